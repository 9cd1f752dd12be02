# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
"""A picture of a page: picture.py PAGE FILE.png [EXPRESSION [light|dark [WIDTH HEIGHT]]]; the expression sets it up."""

import sys

from browser import Browser, find_chromium


def main(page, picture, expression="1", scheme="light", width="1280", height="800"):
    browser = Browser(find_chromium())
    try:
        browser.size(int(width), int(height))
        browser.prefer(color_scheme=scheme)
        browser.open(page)
        browser.frame()
        browser.value(f"void ({expression})")
        browser.screenshot(picture)
        if browser.errors:
            sys.exit("\n".join(browser.errors))
    finally:
        browser.close()


main(*sys.argv[1:])
