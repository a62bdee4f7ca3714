// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstring>
#include <type_traits>

/// What ranks tell each other of a sphere that one owns and others have as a ghost. LIGGGHTS's buffers are of doubles:
/// each message is a struct of nothing else.
namespace interphase::hard_sphere {

/// At the start of a part of a step, from the owner: how the sphere moves, forces included.
struct StartMessage {
    double velocity[3];  ///< [m/s]
    double spin[3];      ///< [rad/s]
    double push[3];      ///< what forces added to the velocity [m/s]
};

/// From the owner, where sizes change while the run goes on.
struct SizeMessage {
    double radius;  ///< [m]
    double mass;    ///< [kg]
};

/// The impulse of a law's attractions: to the owner, where they are added up, and from it.
struct PullMessage {
    double impulse[3];  ///< [kg m/s]
};

/// Contacts that touch the sphere, or ranks that change it. To the owner, where they are added up, and from it.
struct CountMessage {
    double count;
};

/// Velocities: from the owner as they are, to the owner what contacts there changed.
struct MotionMessage {
    double velocity[3];  ///< [m/s]
    double spin[3];      ///< [rad/s]
};

/// To the owner, and with a sphere that changes its owner: what moves it besides its velocity.
struct ShiftMessage {
    double shift[3];  ///< [m]
};

/// How many doubles a message takes.
template <class Message>
inline constexpr int numbers_in = sizeof(Message) / sizeof(double);

constexpr int most_forward = std::max({numbers_in<StartMessage>, numbers_in<CountMessage>, numbers_in<MotionMessage>});
constexpr int most_reverse = std::max({numbers_in<CountMessage>, numbers_in<MotionMessage>, numbers_in<ShiftMessage>});

/// Returns how many doubles were written, or read.
template <class Message>
int pack(const Message& message, double* buffer)
{
    static_assert(std::is_trivially_copyable_v<Message> && sizeof(Message) == numbers_in<Message> * sizeof(double));
    std::memcpy(buffer, &message, sizeof message);
    return numbers_in<Message>;
}
template <class Message>
int unpack(Message& message, const double* buffer)
{
    static_assert(std::is_trivially_copyable_v<Message> && sizeof(Message) == numbers_in<Message> * sizeof(double));
    std::memcpy(&message, buffer, sizeof message);
    return numbers_in<Message>;
}

/// `count` messages, number k being what `tell(k)` returns. Returns the doubles of one, as LIGGGHTS asks for it.
template <class Tell>
int pack_each(int count, double* buffer, const Tell& tell)
{
    for (int k = 0; k < count; ++k)
        buffer += pack(tell(k), buffer);
    return numbers_in<decltype(tell(0))>;
}

/// Calls `take(k, message)` for each of them.
template <class Message, class Take>
void unpack_each(int count, const double* buffer, const Take& take)
{
    for (int k = 0; k < count; ++k) {
        Message message;
        buffer += unpack(message, buffer);
        take(k, message);
    }
}

}  // namespace interphase::hard_sphere
