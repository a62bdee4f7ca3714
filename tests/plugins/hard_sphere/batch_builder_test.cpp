// SPDX-License-Identifier: GPL-3.0-or-later
// Contacts of a batch share no body but fixed ones; each contact gets a place of its own, and lanes fill from 0.
#include "hard_sphere/batch_builder.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>

using namespace interphase::hard_sphere;

namespace {

using Members = std::map<std::size_t, std::vector<std::array<int, 2>>>;

Members built(BatchBuilder& builder, const std::vector<std::array<int, 2>>& contacts, int fixed_from)
{
    Members members;
    for (const auto& [i, j] : contacts) {
        const BatchPlace place = builder.place(i, j, i >= fixed_from, j >= fixed_from);
        EXPECT_LT(place.batch, builder.count());
        EXPECT_EQ(static_cast<std::size_t>(place.lane), members[place.batch].size());
        members[place.batch].push_back({i, j});
    }
    return members;
}

void expect_apart(const Members& members, int fixed_from)
{
    for (const auto& [batch, contacts] : members) {
        EXPECT_LE(contacts.size(), static_cast<std::size_t>(lanes));
        std::set<int> seen;
        for (const auto& contact : contacts)
            for (const int body : contact)
                if (body < fixed_from) {
                    EXPECT_TRUE(seen.insert(body).second) << "body " << body << " twice in batch " << batch;
                }
    }
}

}  // namespace

TEST(BatchBuilder, PutsNoBodyTwiceInABatch)
{
    std::mt19937 random(3);
    for (const int bodies : {3, 10, 100, 3000}) {
        const int fixed_from = bodies - bodies / 10;
        std::uniform_int_distribution<int> any(0, bodies - 1);
        std::vector<std::array<int, 2>> contacts;
        while (contacts.size() < 5000) {
            const int i = any(random), j = any(random);
            if (i != j) contacts.push_back({i, j});
        }
        BatchBuilder builder;
        builder.start(static_cast<std::size_t>(bodies));
        const Members members = built(builder, contacts, fixed_from);
        expect_apart(members, fixed_from);
        EXPECT_EQ(members.size(), builder.count());
    }
}

TEST(BatchBuilder, FillsBatchesWhereContactsAreApart)
{
    std::vector<std::array<int, 2>> contacts;
    for (int k = 0; k < 80 * lanes; ++k)
        contacts.push_back({2 * k, 2 * k + 1});
    BatchBuilder builder;
    builder.start(2 * contacts.size());
    EXPECT_EQ(built(builder, contacts, 1 << 30).size(), contacts.size() / lanes);
}

TEST(BatchBuilder, StartsAnew)
{
    BatchBuilder builder;
    for (int round = 0; round < 2; ++round) {
        builder.start(3);
        EXPECT_EQ(builder.count(), 0u);
        expect_apart(built(builder, {{0, 1}, {1, 2}, {0, 2}, {0, 1}}, 3), 3);
    }
}

TEST(BatchBuilder, LetsAFixedBodyTouchManyAtOnce)
{
    std::vector<std::array<int, 2>> contacts;
    for (int k = 0; k < lanes; ++k)
        contacts.push_back({k, lanes});
    BatchBuilder builder;
    builder.start(lanes + 1);
    EXPECT_EQ(built(builder, contacts, lanes).size(), 1u);
}
