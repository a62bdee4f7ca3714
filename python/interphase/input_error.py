# SPDX-License-Identifier: GPL-3.0-or-later
"""What a tool says of input it cannot use."""


class InputError(Exception):
    """The input cannot be used; the message says what, where, which value and what to do."""
