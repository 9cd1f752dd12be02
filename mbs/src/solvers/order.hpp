// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "tandem/mbs/sparse/pattern.hpp"

namespace tandem::mbs::solvers {

/// By column its place in an order in which the band of a symmetric matrix is narrow: reverse Cuthill-McKee,
/// or the columns' own order where that is as narrow.
std::vector<int> narrow_order(const Pattern& pattern);

/// The farthest that an entry stands from the diagonal if the columns are put to these places.
int band_width(const Pattern& pattern, const std::vector<int>& place);

/// By place the column that stands there in an order with little fill: approximate minimum degree (P.
/// Amestoy, T. A. Davis, I. S. Duff, ACM Trans. Math. Softw. 30 (2004) 381).
std::vector<int> minimum_degree_order(const Pattern& pattern);

/// The same by nested dissection (G. Karypis, V. Kumar, SIAM J. Sci. Comput. 20 (1998) 359); empty if METIS
/// is not there.
std::vector<int> dissection_order(const Pattern& pattern);

}  // namespace tandem::mbs::solvers
