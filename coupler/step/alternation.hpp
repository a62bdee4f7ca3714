// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "base/archive.hpp"
#include "base/vector.hpp"

namespace interphase {

/// How much of a series of vectors, one value a step, is an oscillation of two steps: up, down, up, down. That is the
/// form in which a time stepping goes wrong (a root of its recursion at or beyond -1); what gas and particles do by
/// themselves is resolved by the steps and has longer periods, or has none and is noise.
class Alternation {
public:
    /// Steps that purity and amplitude look back on. White noise of any amplitude has a share p or more of its
    /// variance in one given mode of n with the probability of a beta(1/2, (n - 1)/2) variable; the cubic trend takes
    /// 4 of the 24 steps, so that it exceeds p = 0.85 once in 3e8 steps. Noise that each step takes back in the next
    /// one, x(n) = e(n) - e(n-1), does so once in 5e6 (1.5e7 steps were drawn), x(n) = -x(n-1)/2 + e(n) in 2e5.
    static constexpr int window = 24;

    /// Steps that growth looks back on.
    static constexpr int ratios = 6;

    void add(const Vector& value);

    /// Once the window is full, else 0: the amplitude of the oscillation of two steps over the window [unit of the
    /// values], half of the difference between its ups and downs.
    double amplitude() const { return amplitude_; }
    /// The share that the oscillation of two steps has in the variance of the window, less a cubic trend in time,
    /// which takes out periods from about 20 steps on.
    double purity() const { return purity_; }
    /// Amplitude of the window's younger half over that of the older.
    double persistence() const { return persistence_; }

    /// At once: (x(n) - 2 x(n-1) + x(n-2))/4, its magnitude. Of an oscillation of two steps it is the amplitude.
    double swing() const { return swing_.norm(); }
    /// For how many steps on end the swing has turned round and grown (by more than 2 %).
    int growing() const { return growing_; }
    /// Over the last `ratios` steps: by how much the swing has grown, if it has in each of them, else 0.
    double growth() const { return growing_ >= ratios ? swings_[0] / swings_[ratios] : 0; }
    /// Largest over smallest growth of these steps: 1 if it is exponential, as of an unstable mode.
    double unevenness() const;
    /// The usual (root mean square) swing before it began to grow, over some 100 steps [unit of the values].
    double background() const { return background_; }

    void keep(Archive& archive)
    {
        archive.keep("values", values_.data(), 3 * window);
        archive.keep("known", known_);
        archive.keep("amplitude", amplitude_);
        archive.keep("purity", purity_);
        archive.keep("persistence", persistence_);
        archive.keep("swing", swing_.data(), 3);
        archive.keep("swings", swings_);
        archive.keep("mean_square", mean_square_);
        archive.keep("mean_of", mean_of_);
        archive.keep("growing", growing_);
        archive.keep("background", background_);
    }

private:
    void look_back();
    void follow_swing();

    Eigen::Matrix<double, 3, window> values_ = Eigen::Matrix<double, 3, window>::Zero();  ///< the youngest last
    int known_ = 0;
    double amplitude_ = 0, purity_ = 0, persistence_ = 0;
    Vector swing_ = Vector::Zero();
    std::array<double, ratios + 1> swings_{};  ///< the youngest first
    double mean_square_ = 0;                   ///< of the swing
    int mean_of_ = 0;                          ///< steps
    int growing_ = 0;
    double background_ = 0;
};

}  // namespace interphase
