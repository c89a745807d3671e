// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
