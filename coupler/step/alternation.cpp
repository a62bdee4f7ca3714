// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/alternation.hpp"

#include <algorithm>
#include <cmath>

namespace interphase {

namespace {

constexpr int n = Alternation::window;
constexpr int memory = 100;  // steps of the background

/// Orthonormal series over the window.
struct Modes {
    Eigen::Matrix<double, n, 4> smooth;       ///< span the cubics
    Eigen::Matrix<double, n, 1> alternating;  ///< +1, -1, ... less its cubic part
    double length;                            ///< of that before it was made 1

    Modes()
    {
        for (int i = 0; i < n; ++i) {
            const double t = (2.0 * i + 1 - n) / n;
            smooth.row(i) << 1, t, t * t, t * t * t;
            alternating(i) = i % 2 == 0 ? 1 : -1;
        }
        for (int k = 0; k < 4; ++k) {  // modified Gram-Schmidt
            smooth.col(k).normalize();
            for (int j = k + 1; j < 4; ++j)
                smooth.col(j) -= smooth.col(k).dot(smooth.col(j)) * smooth.col(k);
            alternating -= smooth.col(k).dot(alternating) * smooth.col(k);
        }
        length = alternating.norm();
        alternating /= length;
    }
};

const Modes& modes()
{
    static const Modes only;
    return only;
}

}  // namespace

void Alternation::add(const Vector& value)
{
    for (int i = 1; i < n; ++i)
        values_.col(i - 1) = values_.col(i);
    values_.col(n - 1) = value;
    known_ = std::min(known_ + 1, n);
    if (known_ >= 3) follow_swing();
    if (known_ == n) look_back();
}

void Alternation::look_back()
{
    const Eigen::Matrix<double, 3, n> rest = values_ - values_ * modes().smooth * modes().smooth.transpose();
    const Vector share = rest * modes().alternating;
    const double total = rest.squaredNorm();
    purity_ = total > 0 ? share.squaredNorm() / total : 0;
    amplitude_ = share.norm() / modes().length;
    const double older = (rest.leftCols<n / 2>() * modes().alternating.head<n / 2>()).norm();
    const double younger = (rest.rightCols<n / 2>() * modes().alternating.tail<n / 2>()).norm();
    persistence_ = older > 0 ? younger / older : 0;
}

void Alternation::follow_swing()
{
    const Vector last = swing_;
    swing_ = (values_.col(n - 1) - 2 * values_.col(n - 2) + values_.col(n - 3)) / 4;
    const double product = last.norm() * swing_.norm();
    // turned round: by more than 143 degrees, for a series that has other directions too
    const bool grows = product > 0 && swing_.dot(last) < -0.8 * product && swing_.norm() > 1.02 * last.norm();
    if (grows) {
        ++growing_;
    } else {
        growing_ = 0;
        background_ = mean_of_ > 0 ? std::sqrt(mean_square_) : swing_.norm();
    }
    mean_of_ = std::min(mean_of_ + 1, memory);
    mean_square_ += (swing_.squaredNorm() - mean_square_) / mean_of_;
    std::rotate(swings_.begin(), swings_.end() - 1, swings_.end());
    swings_[0] = swing_.norm();
}

double Alternation::unevenness() const
{
    if (growing_ < ratios) return 0;
    double most = 0, least = 1e300;
    for (std::size_t i = 0; i < ratios; ++i) {
        const double ratio = swings_[i] / swings_[i + 1];
        most = std::max(most, ratio);
        least = std::min(least, ratio);
    }
    return most / least;
}

}  // namespace interphase
