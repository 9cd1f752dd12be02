// Test oracle: the two-mass three-spring test with one coupling scheme, in the plainest code that can be written.
//
// It was written from the specification alone and shares no line with the library, so that agreement of the two means
// something. It keeps every sample of the whole run, evaluates Lagrange polynomials by the textbook product, and copies
// whole histories where it needs them frozen. Speed does not matter here; being easily seen to be right does.
//
//   two_mass_oracle SCHEDULE TO_FAST TO_SLOW FR [--cycles N] [--steps-per-cycle N] [--trace FILE]
//                   [--start cold|exact|derivatives|repeat] [--reuse-acceleration] [--model]
//
//   SCHEDULE          slowest-first, fastest-first, parallel, staggered
//   TO_FAST, TO_SLOW  lagrange0 .. lagrange4, hermite, least_squaresDEGREE_EXTRA, matched_hold, mean (TO_SLOW only)
//
// It prints one CSV line:
//   schedule,to_fast,to_slow,frequency_ratio,position_error,energy_error,exchange_energy_error,amplitude_error,
//   phase_error,final_x1,final_v1,final_x2,final_v2,fast_steps,slow_steps,calls
//
// Both sides cut their last step at the end of the run. Without --start: derivatives for degrees up to 3, repeat above.
//
// Readings of the specification: the position error takes every fast node including the start and cut steps, the energy
// error those of them up to the slow side's last node. The amplitude error is signed (negative: damped) and so is the
// phase error (positive: the computed motion leads, in -pi .. pi). The exchange energy error takes each call of the
// schedule (parallel: each round), without the start. Steps are those of the final histories, calls those of the schedule:
// what a repeated start throws away is in neither.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

// ---------------------------------------------------------------------------------------------------------- basics

const double pi = 3.14159265358979323846;
const double t_start = 0.0;

[[noreturn]] void refuse(const std::string& why) {
    std::fprintf(stderr, "two_mass_oracle: %s\n", why.c_str());
    std::exit(2);
}

// Is time a before time b, by more than rounding?
bool before(double a, double b) {
    const double largest = std::max({std::fabs(a), std::fabs(b), std::fabs(t_start)});
    return a < b - 4.0 * std::numeric_limits<double>::epsilon() * largest;
}

// Gaussian elimination with row exchange.
std::vector<long double> solve(std::vector<std::vector<long double>> m, std::vector<long double> rhs) {
    const std::size_t n = rhs.size();
    for (std::size_t c = 0; c < n; ++c) {
        std::size_t pivot = c;
        for (std::size_t r = c; r < n; ++r)
            if (std::fabs(m[r][c]) > std::fabs(m[pivot][c])) pivot = r;
        std::swap(m[c], m[pivot]);
        std::swap(rhs[c], rhs[pivot]);
        for (std::size_t r = c + 1; r < n; ++r) {
            const long double factor = m[r][c] / m[c][c];
            for (std::size_t k = c; k < n; ++k) m[r][k] -= factor * m[c][k];
            rhs[r] -= factor * rhs[c];
        }
    }
    for (std::size_t c = n; c-- > 0;) {
        for (std::size_t k = c + 1; k < n; ++k) rhs[c] -= m[c][k] * rhs[k];
        rhs[c] /= m[c][c];
    }
    return rhs;
}

// Coefficients of the best fit: rows[i] holds the base functions at point i. Normal equations in long double.
std::vector<long double> fit(const std::vector<std::vector<long double>>& rows, const std::vector<double>& values) {
    const std::size_t n = rows[0].size();
    std::vector<std::vector<long double>> m(n, std::vector<long double>(n, 0.0L));
    std::vector<long double> rhs(n, 0.0L);
    for (std::size_t i = 0; i < rows.size(); ++i)
        for (std::size_t r = 0; r < n; ++r) {
            for (std::size_t c = 0; c < n; ++c) m[r][c] += rows[i][r] * rows[i][c];
            rhs[r] += rows[i][r] * values[i];
        }
    return solve(m, rhs);
}

// ----------------------------------------------------------------------------------------------------------- model

struct Model {
    double w1, w2;                // angular frequencies of the fast and the slow mode
    double c11, c13, c21, c23;    // amplitudes: x1 = c11 cos w1 t + c13 cos w2 t, x2 = c21 cos w1 t + c23 cos w2 t
    double m1, m2, k1, k2, k3;

    explicit Model(double frequency_ratio) {
        w1 = 2.0 * pi;
        w2 = w1 / frequency_ratio;
        c11 = 1.0;
        c13 = c11 / 0.1;
        c23 = c11 / 0.1;
        c21 = c23 / -1000.0;
        k2 = 1.0;
        const double a = c11 / c21, b = c13 / c23, difference = w1 * w1 - w2 * w2;
        m1 = k2 * (a - b) / (a * b * difference);
        m2 = k2 * (b - a) / difference;
        k1 = k2 / b - k2 + w2 * w2 * m1;
        k3 = b * k2 - k2 + w2 * w2 * m2;
    }
    double x1(double t) const { return c11 * std::cos(w1 * t) + c13 * std::cos(w2 * t); }
    double v1(double t) const { return -c11 * w1 * std::sin(w1 * t) - c13 * w2 * std::sin(w2 * t); }
    double x2(double t) const { return c21 * std::cos(w1 * t) + c23 * std::cos(w2 * t); }
    double v2(double t) const { return -c21 * w1 * std::sin(w1 * t) - c23 * w2 * std::sin(w2 * t); }
    double a1(double x1, double x2) const { return (-(k1 + k2) * x1 + k2 * x2) / m1; }
    double a2(double x1, double x2) const { return (k2 * x1 - (k2 + k3) * x2) / m2; }
    double energy(double x1, double v1, double x2, double v2) const {
        return 0.5 * (m1 * v1 * v1 + m2 * v2 * v2 + k1 * x1 * x1 + k2 * (x2 - x1) * (x2 - x1) + k3 * x2 * x2);
    }
};

// ------------------------------------------------------------------------------------------------- reconstructions

struct Sample { double t, y, dy; };
using History = std::vector<Sample>;

struct Reconstruction {
    enum Kind { lagrange, hermite, mean, least_squares, matched_hold } kind;
    int degree, extra;
};

Reconstruction parse_reconstruction(const std::string& name) {
    for (int d = 0; d <= 4; ++d) {
        if (name == "lagrange" + std::to_string(d)) return {Reconstruction::lagrange, d, 0};
        for (int e = 0; e <= 9; ++e)
            if (name == "least_squares" + std::to_string(d) + "_" + std::to_string(e))
                return {Reconstruction::least_squares, d, e};
    }
    if (name == "hermite") return {Reconstruction::hermite, 3, 0};
    if (name == "mean") return {Reconstruction::mean, 0, 0};
    if (name == "matched_hold") return {Reconstruction::matched_hold, 0, 0};
    refuse("unknown reconstruction " + name);
}

// Node rule: the first sample at or after t if there is one, else the newest.
int right_node(const History& s, double t) {
    int j = static_cast<int>(s.size()) - 1;
    while (j > 0 && !before(s[j - 1].t, t)) --j;
    return j;
}

double lagrange_value(const History& s, int first, int last, double t) {
    double sum = 0.0;
    for (int i = first; i <= last; ++i) {
        double product = s[i].y;
        for (int k = first; k <= last; ++k)
            if (k != i) product *= (t - s[k].t) / (s[i].t - s[k].t);
        sum += product;
    }
    return sum;
}

// The cubic through the values and derivatives at a and b, and its derivative.
Sample hermite_value(const Sample& a, const Sample& b, double t) {
    const double h = b.t - a.t, s = (t - a.t) / h;
    const double y = a.y * (1 + 2 * s) * (1 - s) * (1 - s) + a.dy * h * s * (1 - s) * (1 - s) +
                     b.y * s * s * (3 - 2 * s) + b.dy * h * s * s * (s - 1);
    const double dy = (b.y - a.y) / h * 6 * s * (1 - s) + a.dy * (1 - s) * (1 - 3 * s) + b.dy * s * (3 * s - 2);
    return {t, y, dy};
}

double least_squares_value(const History& s, int first, int last, int degree, double t) {
    if (first == last) return s[last].y;
    const long double origin = s[last].t, width = s[last].t - s[first].t;
    std::vector<std::vector<long double>> rows;
    std::vector<double> values;
    for (int i = first; i <= last; ++i) {
        std::vector<long double> row;
        for (int p = 0; p <= std::min(degree, last - first); ++p) row.push_back(std::pow((s[i].t - origin) / width, p));
        rows.push_back(row);
        values.push_back(s[i].y);
    }
    const std::vector<long double> c = fit(rows, values);
    long double sum = 0.0L;
    for (std::size_t p = 0; p < c.size(); ++p) sum += c[p] * std::pow((t - origin) / width, static_cast<int>(p));
    return static_cast<double>(sum);
}

double mean_value(const History& s, double begin, double end) {
    double sum = 0.0;
    int count = 0, newest_before = 0;
    for (int i = 0; i < static_cast<int>(s.size()); ++i) {
        if (before(s[i].t, begin)) newest_before = i;
        else if (!before(end, s[i].t)) { sum += s[i].y; ++count; }
    }
    return count > 0 ? sum / count : s[newest_before].y;
}

// What a subsystem reads during one call.
struct Input {
    Reconstruction how;
    History source;             // a copy: as it was when the call began
    bool whole_window = false;  // later passes of a repeated start: the first segments use the nodes of the first full one

    // The value at t; the reader's step is from `begin` to `end`.
    double at(double t, double begin, double end) const {
        if (how.kind == Reconstruction::matched_hold) return source.back().y;
        if (how.kind == Reconstruction::mean) return mean_value(source, begin, end);
        const int reach = how.kind == Reconstruction::hermite ? 1 : how.degree + how.extra;
        int j = right_node(source, t);
        if (whole_window && j < reach) j = std::min(reach, static_cast<int>(source.size()) - 1);
        const int first = std::max(0, j - reach);
        if (how.kind == Reconstruction::lagrange) return lagrange_value(source, first, j, t);
        if (how.kind == Reconstruction::least_squares) return least_squares_value(source, first, j, how.degree, t);
        if (j == 0) return source[0].y + source[0].dy * (t - source[0].t);
        return hermite_value(source[j - 1], source[j], t).y;
    }
};

// ------------------------------------------------------------------------------------------------------ subsystems

struct Side {
    bool fast;
    double h;
    double t_stop;    // where the run ends: the last step is cut there
    History past;     // invented samples before the start
    History nodes;    // what this side computed, from the start on: time, displacement, velocity
    double k = 0;     // the newest node of the side's own grid
    double stored_acceleration = 0.0;

    double time() const { return nodes.back().t; }
    double next() const { return std::min(t_start + (k + 1) * h, t_stop); }
    bool finished() const { return !before(time(), t_stop); }
    long steps() const { return static_cast<long>(nodes.size()) - 1; }
    History history() const {
        History all = past;
        all.insert(all.end(), nodes.begin(), nodes.end());
        return all;
    }
};

// Classical Runge-Kutta for mass 1, input x2.
void step_fast(const Model& m, Side& side, const Input& x2, double end) {
    const Sample s = side.nodes.back();
    const double t = s.t, h = end - t;
    const double u0 = x2.at(t, t, end), u1 = x2.at(t + h / 2, t, end), u2 = x2.at(end, t, end);
    const double x_a = s.y, v_a = s.dy, a_a = m.a1(x_a, u0);
    const double x_b = s.y + h / 2 * v_a, v_b = s.dy + h / 2 * a_a, a_b = m.a1(x_b, u1);
    const double x_c = s.y + h / 2 * v_b, v_c = s.dy + h / 2 * a_b, a_c = m.a1(x_c, u1);
    const double x_d = s.y + h * v_c, v_d = s.dy + h * a_c, a_d = m.a1(x_d, u2);
    side.nodes.push_back({end, s.y + h / 6 * (v_a + 2 * v_b + 2 * v_c + v_d), s.dy + h / 6 * (a_a + 2 * a_b + 2 * a_c + a_d)});
}

// Trapezoidal rule for mass 2, input x1. v' = v + h/2 (a + a'), x' = x + h/2 (v + v'), a' = (k2 u' - (k2 + k3) x') / m2.
void step_slow(const Model& m, Side& side, const Input& x1, double end, bool reuse_acceleration) {
    const Sample s = side.nodes.back();
    const double t = s.t, h = end - t;
    const double u0 = x1.at(t, t, end), u1 = x1.at(end, t, end);
    const double a0 = reuse_acceleration && side.steps() > 0 ? side.stored_acceleration : m.a2(u0, s.y);
    const double x = (s.y + h * s.dy + h * h / 4 * (a0 + m.k2 * u1 / m.m2)) / (1 + h * h / 4 * (m.k2 + m.k3) / m.m2);
    const double a1 = m.a2(u1, x);
    side.nodes.push_back({end, x, s.dy + h / 2 * (a0 + a1)});
    side.stored_acceleration = a1;
}

// ------------------------------------------------------------------------------------------------------------- run

struct Run {
    Model model;
    std::string schedule;
    Reconstruction to_fast, to_slow;
    double t_stop;
    bool reuse_acceleration;
    Side fast, slow;
    long calls = 0;
    std::vector<double> exchange_energies;

    void step(Side& side, const Input& input, double end) {
        if (side.fast) step_fast(model, side, input, end);
        else step_slow(model, side, input, end, reuse_acceleration);
    }

    // All own steps that end at or before the limit; with `land`, a shortened one to the limit itself.
    void advance(Side& side, const Input& input, double limit, bool land) {
        while (!side.finished() && !before(limit, side.next())) {
            step(side, input, side.next());
            ++side.k;
        }
        if (land && before(side.time(), limit)) step(side, input, limit);
    }

    Input input_of(const Side& reader) const {
        return {reader.fast ? to_fast : to_slow, reader.fast ? slow.history() : fast.history()};
    }

    void call(Side& side, double limit, bool land = false) {
        advance(side, input_of(side), limit, land);
        ++calls;
    }

    void note_energy() {
        const Sample &f = fast.nodes.back(), &s = slow.nodes.back();
        exchange_energies.push_back(model.energy(f.y, f.dy, s.y, s.dy));
    }

    // ---- schedules: each does one turn and returns false at the end

    bool turn_in_order(Side& first, Side& second) {
        const bool first_open = !first.finished(), second_open = !second.finished();
        if (!first_open && !second_open) return false;
        Side* p = first_open ? &first : &second;
        if (first_open && second_open && before(second.next(), first.next())) p = &second;
        if (p == &second && first_open && before(first.time(), second.next())) p = &first;
        double limit = t_stop;
        if (p == &second && first_open) limit = first.time();
        if (p == &first && second_open) limit = second.next();
        if (!p->fast && to_slow.kind == Reconstruction::mean) limit = p->next();
        call(*p, std::max(p->next(), std::min(t_stop, limit)));
        return true;
    }

    bool turn_parallel() {
        const bool fast_open = !fast.finished(), slow_open = !slow.finished();
        if (!fast_open && !slow_open) return false;
        double smallest = std::numeric_limits<double>::infinity();
        if (fast_open) smallest = std::min(smallest, fast.next());
        if (slow_open) smallest = std::min(smallest, slow.next());
        const double interval = std::max(fast.h, slow.h);
        double k = 0;
        while (before(t_start + k * interval, smallest)) ++k;
        const double target = std::min(t_stop, t_start + k * interval);
        const Input for_fast = input_of(fast), for_slow = input_of(slow);  // frozen for the round
        if (fast_open && !before(target, fast.next())) { advance(fast, for_fast, target, false); ++calls; }
        if (slow_open && !before(target, slow.next())) { advance(slow, for_slow, target, false); ++calls; }
        return true;
    }

    bool turn_staggered() {
        const bool slow_open = !slow.finished();
        if (!slow_open && fast.finished()) return false;
        const double middle = slow.time() + (slow.next() - slow.time()) / 2;
        if (slow_open && before(fast.time(), middle)) call(fast, middle, true);
        else if (slow_open) call(slow, slow.next());
        else call(fast, t_stop);
        return true;
    }

    bool turn() {
        if (schedule == "slowest-first") return turn_in_order(slow, fast);
        if (schedule == "fastest-first") return turn_in_order(fast, slow);
        if (schedule == "parallel") return turn_parallel();
        return turn_staggered();
    }

    // ---- start

    // Past samples of `side` for a reader that uses `how`, at t_start - k h, oldest first.
    void seed(Side& side, const Reconstruction& how, bool exact) {
        const double dy = side.nodes[0].dy, y = side.nodes[0].y;
        const double x1 = fast.nodes[0].y, x2 = slow.nodes[0].y;
        const double ddy = side.fast ? model.a1(x1, x2) : model.a2(x1, x2);
        const bool polynomial = how.kind == Reconstruction::lagrange || how.kind == Reconstruction::least_squares;
        int count = polynomial ? how.degree + how.extra : how.kind == Reconstruction::hermite ? 1 : 0;
        if (!exact && how.degree < 2) count = 0;  // the first sample alone costs no order there
        for (int k = count; k >= 1; --k) {
            const double t = t_start - k * side.h, s = -k * side.h;
            if (exact && side.fast) side.past.push_back({t, model.x1(t), model.v1(t)});
            else if (exact) side.past.push_back({t, model.x2(t), model.v2(t)});
            else side.past.push_back({t, y + s * dy + s * s / 2 * ddy, dy + s * ddy});
        }
    }

    // Samples that one segment is made of, where a start is of use.
    static int samples(const Reconstruction& how) {
        if (how.degree < 2) return 1;
        return how.kind == Reconstruction::hermite ? 2 : how.degree + 1 + how.extra;
    }

    // Waveform relaxation, both sides at once, d + 1 passes over as many slow steps as a segment has samples. The first
    // pass reads the first samples alone; the last one stands.
    void repeat_start() {
        const int d = std::max(to_fast.degree, to_slow.degree);
        const double window_end = std::min(t_stop, t_start + std::max(samples(to_fast), samples(to_slow)) * slow.h);
        for (int pass = 1; pass <= d + 1; ++pass) {
            Input for_fast = input_of(fast), for_slow = input_of(slow);  // of the pass before
            for_fast.whole_window = for_slow.whole_window = pass > 1;
            for (Side* side : {&fast, &slow}) {
                side->nodes.resize(1);
                side->k = 0;
            }
            advance(fast, for_fast, window_end, false);
            advance(slow, for_slow, window_end, false);
        }
    }

    void begin(std::string start) {
        const bool held = to_fast.kind == Reconstruction::matched_hold && to_slow.kind == Reconstruction::matched_hold;
        if (start.empty()) start = std::max(to_fast.degree, to_slow.degree) <= 3 ? "derivatives" : "repeat";
        if (start == "repeat" && std::max(to_fast.degree, to_slow.degree) < 2) start = "cold";  // nothing to gain
        if (start == "repeat" && !held) repeat_start();
        else if (start == "exact" || start == "derivatives") {
            seed(slow, to_fast, start == "exact");
            seed(fast, to_slow, start == "exact");
        } else if (start != "cold" && !held) refuse("unknown start " + start);
    }

    void run(const std::string& start) {
        begin(start);
        while (turn()) note_energy();
    }
};

// ---------------------------------------------------------------------------------------------------------- errors

struct Errors { double position, energy, exchange_energy, amplitude, phase; };

double root_mean_square(const std::vector<double>& values) {
    double sum = 0.0;
    for (double v : values) sum += v * v;
    return std::sqrt(sum / static_cast<double>(values.size()));
}

std::vector<double> relative_to(const std::vector<double>& values, double reference) {
    std::vector<double> out;
    for (double v : values) out.push_back((v - reference) / reference);
    return out;
}

double position_error(const Run& r, double factor) {
    std::vector<double> computed, difference;
    for (const Sample& s : r.fast.nodes) {
        computed.push_back(s.y);
        difference.push_back(s.y - r.model.x1(s.t));
    }
    return factor * root_mean_square(difference) / root_mean_square(computed);
}

// The slow side's state at the fast nodes: x2 is the cubic Hermite polynomial of the slow positions and velocities, and
// v2 its derivative (the specification's "from the slow side's positions and velocities", read so).
double energy_error(const Run& r, double factor, double e0) {
    std::vector<double> energies;
    for (const Sample& f : r.fast.nodes) {
        if (before(r.slow.time(), f.t)) break;
        const int j = right_node(r.slow.nodes, f.t);
        const Sample s = j == 0 ? r.slow.nodes[0] : hermite_value(r.slow.nodes[j - 1], r.slow.nodes[j], f.t);
        energies.push_back(r.model.energy(f.y, f.dy, s.y, s.dy));
    }
    return factor * root_mean_square(relative_to(energies, e0));
}

// Fast mode over the last ten fast cycles: x1 = A cos w1 t + B sin w1 t + C cos w2 t + D sin w2 t.
void fast_mode(const Run& r, double& amplitude_error, double& phase_error) {
    std::vector<std::vector<long double>> rows;
    std::vector<double> values;
    for (const Sample& s : r.fast.nodes) {
        if (before(s.t, r.t_stop - 10.0)) continue;
        const double p1 = r.model.w1 * s.t, p2 = r.model.w2 * s.t;
        rows.push_back({std::cos(p1), std::sin(p1), std::cos(p2), std::sin(p2)});
        values.push_back(s.y);
    }
    const std::vector<long double> c = fit(rows, values);
    const double a = static_cast<double>(c[0]), b = static_cast<double>(c[1]);
    amplitude_error = std::hypot(a, b) / r.model.c11 - 1.0;
    phase_error = std::atan2(-b, a);
}

Errors errors_of(const Run& r, double frequency_ratio, double cycles) {
    const double factor = frequency_ratio / cycles;
    const double e0 = r.model.energy(r.fast.nodes[0].y, r.fast.nodes[0].dy, r.slow.nodes[0].y, r.slow.nodes[0].dy);
    Errors e{};
    e.position = position_error(r, factor);
    e.energy = energy_error(r, factor, e0);
    e.exchange_energy = factor * root_mean_square(relative_to(r.exchange_energies, e0));
    fast_mode(r, e.amplitude, e.phase);
    return e;
}

// ------------------------------------------------------------------------------------------------------------ main

void check(const std::string& schedule, const Reconstruction& to_fast, const Reconstruction& to_slow) {
    const bool fast_held = to_fast.kind == Reconstruction::matched_hold, slow_held = to_slow.kind == Reconstruction::matched_hold;
    if (schedule != "slowest-first" && schedule != "fastest-first" && schedule != "parallel" && schedule != "staggered")
        refuse("unknown schedule " + schedule);
    if (schedule == "staggered" && !(fast_held && slow_held)) refuse("staggered needs matched_hold both ways");
    if (schedule == "parallel" && (fast_held || slow_held)) refuse("matched_hold needs turns");
    if (to_fast.kind == Reconstruction::mean) refuse("mean is for the slow side's input only");
    if (to_slow.kind == Reconstruction::mean && schedule != "fastest-first") refuse("mean needs fastest-first");
}

void write_trace(const Run& r, const std::string& file) {
    std::FILE* out = std::fopen(file.c_str(), "w");
    if (out == nullptr) refuse("cannot write " + file);
    std::fprintf(out, "time,x1,v1\n");
    for (const Sample& s : r.fast.nodes) std::fprintf(out, "%.17g,%.17g,%.17g\n", s.t, s.y, s.dy);
    std::fclose(out);
}

int main(int argc, char** argv) {
    if (argc < 5) refuse("usage: two_mass_oracle SCHEDULE TO_FAST TO_SLOW FR [options]");
    const double frequency_ratio = std::atof(argv[4]);
    double cycles = 100.0, steps_per_cycle = 100.0;
    bool reuse = false, show_model = false;
    std::string start, trace;
    for (int i = 5; i < argc; ++i) {
        const std::string option = argv[i];
        const bool has_value = i + 1 < argc;
        if (option == "--reuse-acceleration") reuse = true;
        else if (option == "--model") show_model = true;
        else if (option == "--cycles" && has_value) cycles = std::atof(argv[++i]);
        else if (option == "--steps-per-cycle" && has_value) steps_per_cycle = std::atof(argv[++i]);
        else if (option == "--start" && has_value) start = argv[++i];
        else if (option == "--trace" && has_value) trace = argv[++i];
        else refuse("unknown option " + option);
    }
    const Reconstruction to_fast = parse_reconstruction(argv[2]), to_slow = parse_reconstruction(argv[3]);
    check(argv[1], to_fast, to_slow);

    const Model m(frequency_ratio);
    if (show_model)
        std::fprintf(stderr, "m1=%.9g m2=%.9g k1=%.9g k2=%.9g k3=%.9g x1(0)=%.9g x2(0)=%.9g\n", m.m1, m.m2, m.k1, m.k2, m.k3,
                     m.x1(0), m.x2(0));
    const double t_stop = t_start + cycles;
    Side fast{true, 1.0 / steps_per_cycle, t_stop, {}, {{t_start, m.x1(t_start), m.v1(t_start)}}};
    Side slow{false, frequency_ratio / steps_per_cycle, t_stop, {}, {{t_start, m.x2(t_start), m.v2(t_start)}}};
    Run r{m, argv[1], to_fast, to_slow, t_stop, reuse, fast, slow, 0, {}};
    r.run(start);

    const Errors e = errors_of(r, frequency_ratio, cycles);
    const Sample &f = r.fast.nodes.back(), &s = r.slow.nodes.back();
    std::printf("%s,%s,%s,%.17g,", argv[1], argv[2], argv[3], frequency_ratio);
    std::printf("%.17g,%.17g,%.17g,%.17g,%.17g,", e.position, e.energy, e.exchange_energy, e.amplitude, e.phase);
    std::printf("%.17g,%.17g,%.17g,%.17g,%ld,%ld,%ld\n", f.y, f.dy, s.y, s.dy, r.fast.steps(), r.slow.steps(), r.calls);
    if (!trace.empty()) write_trace(r, trace);
    return 0;
}
