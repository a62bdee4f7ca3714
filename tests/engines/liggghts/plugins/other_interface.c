/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A plug-in of a version to come: after the version nothing is where this one has it. */
#include <stdint.h>

static const struct {
    uint32_t interface_version;
    uint32_t unknown[7];
} descriptor = {4711, {1, 2, 3, 4, 5, 6, 7}};

const void* interphase_plugin(void) { return &descriptor; }
