/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Has the function, which describes nothing. */
const void* interphase_plugin(void) { return 0; }
