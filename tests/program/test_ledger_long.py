# SPDX-License-Identifier: GPL-3.0-or-later
# label: slow
# timeout: 3600
# processors: 2
"""Momentum and solid volume of cases/sscp1 balance to 1e-12 in each of 1000 coupling steps, on 1, 2 and 4 ranks."""

import balances
import support


class Balances(balances.BalancesOfSscp1, support.ProgramTest):
    steps = 1000
