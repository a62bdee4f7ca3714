// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace interphase::hard_sphere {

/// What a law says of one contact (eqs. 10 and 11 of the paper).
struct Response {
    double restitution = 1;             ///< e_n, 0 to 1
    double tangential_restitution = 1;  ///< e_t, 0 to 1, of a sticking contact
    double friction = 0;                ///< mu >= 0
    double rolling_arm = 0;  ///< mu_r r_e >= 0: the largest couple against rolling, over the normal impulse [m]
};

}  // namespace interphase::hard_sphere
