// SPDX-License-Identifier: GPL-3.0-or-later
// Declares a function and forgets to define it.
namespace forgotten {
int function(double);
}

extern "C" const void* interphase_plugin() { return forgotten::function(1.0) > 0 ? "" : nullptr; }
