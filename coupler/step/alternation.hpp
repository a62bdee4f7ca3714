// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/vector.hpp"

namespace interphase {

/// How much of a series of vectors, one value a step, is an oscillation of two steps: up, down, up, down. That is the
/// form in which a time stepping goes wrong (a root of its recursion at or beyond -1); what gas and particles do by
/// themselves is resolved by the steps and has longer periods, or has none and is noise.
class Alternation {
public:
    /// Steps that purity and amplitude look back on. White noise of any amplitude has a share p or more of its
    /// variance in one given mode of n with the probability of a beta(1/2, (n - 1)/2) variable; the cubic trend takes
    /// 4 of the 24 steps, so that it exceeds p = 0.8 once in 2e7 steps.
    static constexpr int window = 24;

    void add(const Vector& value);
    void forget();

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
    /// Swing now over the swing before it began to grow.
    double growth() const { return first_ > 0 ? swing() / first_ : 0; }
    /// The usual (root mean square) swing of the steps before it began to grow [unit of the values].
    double background() const { return background_; }

private:
    void look_back();
    void follow_swing();

    Eigen::Matrix<double, 3, window> values_ = Eigen::Matrix<double, 3, window>::Zero();  ///< the youngest last
    int known_ = 0;
    double amplitude_ = 0, purity_ = 0, persistence_ = 0;
    Vector swing_ = Vector::Zero();
    double mean_square_ = 0;  ///< of the swing
    int growing_ = 0;
    double first_ = 0, background_ = 0;
};

}  // namespace interphase
