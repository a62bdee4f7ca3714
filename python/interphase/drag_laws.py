# SPDX-License-Identifier: GPL-3.0-or-later
"""Drag laws, written down a second time from the papers, to hold the program's against.

Each gives the drag over Stokes's, F(voidage, Re), with beta = 18 mu eps (1 - eps) F/d^2 and Re = eps rho |u - v| d/mu: the force of the
drag on a particle is V_p 18 mu eps F slip/d^2.
"""

import math


def _single(re):
    """C_D Re/24 of an isolated sphere: Schiller and Naumann, Z. Ver. Dtsch. Ing. 77 (1933) 318; C_D = 0.44 from Re = 1000 on."""
    return 1 + 0.15 * re**0.687 if re < 1000 else 0.44 * re / 24


def schiller_naumann(eps, re):
    """Of a sphere that feels no others: its Reynolds number is that of the slip itself."""
    return _single(re / eps) / eps


def wen_yu(eps, re):
    """Wen and Yu, Chem. Eng. Prog. Symp. Ser. 62 (1966) 100, with C_D of Schiller and Naumann."""
    return _single(re) * eps**-3.65


def ergun(eps, re):
    """Ergun, Chem. Eng. Prog. 48 (1952) 89: dp/L = 150 mu (1-eps)^2 U/(eps^3 d^2) + 1.75 rho (1-eps) U^2/(eps^3 d)."""
    return (150 * (1 - eps) + 1.75 * re) / (18 * eps**2)


def gidaspow(eps, re):
    """Gidaspow, Multiphase Flow and Fluidization, Academic Press (1994)."""
    return ergun(eps, re) if eps < 0.8 else wen_yu(eps, re)


def bvk(eps, re):
    """Beetstra, van der Hoef and Kuipers, AIChE J. 53 (2007) 489."""
    phi = 1 - eps
    drag = 10 * phi / eps**2 + eps**2 * (1 + 1.5 * math.sqrt(phi))
    if re <= 0:
        return drag
    quotient = (1 / eps + 3 * eps * phi + 8.4 * re**-0.343) / (1 + 10 ** (3 * phi) * re ** (-0.5 - 2 * phi))
    return drag + 0.413 * re / (24 * eps**2) * quotient


def di_felice(eps, re):
    """Di Felice, Int. J. Multiphase Flow 20 (1994) 153."""
    if re <= 0:
        return 4.8**2 / 24  # its limit, on which the exponent of the voidage has no say at 1
    exponent = 3.7 - 0.65 * math.exp(-0.5 * (1.5 - math.log10(re)) ** 2)
    return re / 24 * (0.63 + 4.8 / math.sqrt(re)) ** 2 * eps**-exponent


LAWS = {"SchillerNaumann": schiller_naumann, "BVK": bvk, "Ergun": ergun, "WenYu": wen_yu, "Gidaspow": gidaspow, "DiFelice": di_felice}
