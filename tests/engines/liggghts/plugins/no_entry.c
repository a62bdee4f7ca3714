/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A library like any other. */
int answer_of_a_library(void) { return 42; }
