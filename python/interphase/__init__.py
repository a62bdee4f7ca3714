# SPDX-License-Identifier: GPL-3.0-or-later
"""Cases and runs of interphase: what tools/* are made of, and scripts of one's own."""
