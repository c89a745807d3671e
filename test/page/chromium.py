# Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
#
# This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

"""Starts Chromium for a test, or says that the test is skipped."""

import shutil
import sys

SKIPPED = 77
try:
    from selenium import webdriver
    from selenium.webdriver.chrome.service import Service
except ImportError:
    print("python3-selenium is not installed: skipped")
    sys.exit(SKIPPED)


def start_browser():
    chromium, driver = shutil.which("chromium"), shutil.which("chromedriver")
    if not chromium or not driver:
        print("Chromium and chromium-driver are not installed: skipped")
        sys.exit(SKIPPED)
    options = webdriver.ChromeOptions()
    options.binary_location = chromium
    for argument in ["--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--use-gl=angle",
                     "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-background-networking"]:
        options.add_argument(argument)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    return webdriver.Chrome(service=Service(driver), options=options)
