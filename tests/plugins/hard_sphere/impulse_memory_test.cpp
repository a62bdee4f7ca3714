// SPDX-License-Identifier: GPL-3.0-or-later
// What a sphere remembers of its contacts goes to another rank whole, however many there are.
#include "hard_sphere/impulse_memory.hpp"

#include <gtest/gtest.h>

using namespace interphase::hard_sphere;

namespace {

constexpr int contacts = 1000, beside = 2;

ImpulseMemory full()
{
    ImpulseMemory memory(beside);
    memory.grow(2);
    for (int k = 1; k <= contacts; ++k) {
        Remembered entry{k};
        entry.impulse[0] = static_cast<float>(k);
        memory.add(1, entry);
        memory.add_more()[1] = static_cast<float>(-k);
    }
    return memory;
}

}  // namespace

TEST(ImpulseMemory, GoesWithASphereOfAThousandContacts)
{
    const ImpulseMemory memory = full();
    std::vector<double> buffer(static_cast<std::size_t>(memory.numbers(1)));
    int left_out = -1;
    EXPECT_EQ(memory.pack(1, buffer.data(), memory.numbers(1), left_out), memory.numbers(1));
    EXPECT_EQ(left_out, 0);

    ImpulseMemory there(beside);
    there.grow(1);
    EXPECT_EQ(there.unpack(0, buffer.data()), memory.numbers(1));
    for (int k = 1; k <= contacts; ++k) {
        const int found = there.find(there.first(0), k);
        ASSERT_NE(found, 0);
        EXPECT_EQ(there.entry(found).impulse[0], static_cast<float>(k));
        EXPECT_EQ(there.more(found)[1], static_cast<float>(-k));
    }
}

TEST(ImpulseMemory, WritesNoMoreThanThereIsRoomForAndSaysHowManyItLeftOut)
{
    const ImpulseMemory memory = full();
    const int room = 100;
    std::vector<double> buffer(room + 1, 7.0);
    int left_out = 0;
    const int written = memory.pack(1, buffer.data(), room, left_out);
    EXPECT_LE(written, room);
    EXPECT_EQ(buffer.back(), 7.0);
    EXPECT_EQ(left_out, contacts - 16);  // of six numbers each, after their count
    ImpulseMemory there(beside);
    there.grow(1);
    EXPECT_EQ(there.unpack(0, buffer.data()), written);
    EXPECT_EQ(memory.numbers(0), 1);
}
