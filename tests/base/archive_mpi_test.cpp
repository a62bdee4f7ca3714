// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a run on some ranks has taken in is given to others: alike, as shares of a sum, cell by cell; and what has no
// such rule is refused by name.
#include <gtest/gtest.h>

#include <numeric>

#include "base/archive.hpp"
#include "exchange/moved_cells.hpp"
#include "support/world.hpp"

namespace {

using namespace interphase;
using test::world;

struct Sums {
    double number, more[2];
};

/// Ten cells in turn to `ranks` ranks.
std::vector<int> cells_of(int rank, int ranks)
{
    std::vector<int> numbers;
    for (int cell = rank; cell < 10; cell += ranks)
        numbers.push_back(cell);
    return numbers;
}

struct Object {
    double same = 7.5;
    std::optional<double> maybe;
    long count = 0;
    Sums sums{};
    int largest = 0;
    std::vector<double> of_cells;  ///< two each
    std::vector<double> none;

    void keep(Archive& archive)
    {
        archive.keep("same", same);
        archive.keep("maybe", maybe);
        archive.keep_share("count", count);
        archive.keep_share("sums", sums);
        archive.keep_largest("largest", largest);
        archive.keep_cells("of_cells", of_cells);
        archive.keep_cells("none", none);
    }
};

/// What rank `rank` of `ranks` takes in.
Archive::State state_of(int rank, int ranks)
{
    Archive archive;
    std::vector<int> numbers = cells_of(rank, ranks);
    Object object;
    object.maybe = 2;
    object.count = 10 + rank;
    object.sums = {1.5, {double(rank), 1}};
    object.largest = 3 * rank;
    for (const int number : numbers)
        object.of_cells.insert(object.of_cells.end(), {number + 0.5, -double(number)});
    archive.keep("numbers", numbers);
    int own = rank;
    archive.keep("own", own);
    archive.within("object", [&] { object.keep(archive); });
    return archive.state();
}

/// Of a run on `ranks`, as its files are shared out.
Archive saved_by(int ranks)
{
    std::map<int, Archive::State> mine;
    for (int rank = world().rank(); rank < ranks; rank += world().size())
        mine[rank] = state_of(rank, ranks);
    return Archive::loading(world(), ranks, std::move(mine));
}

Archive::CellMoves moves_of(const Archive& archive)
{
    const std::vector<int> own = cells_of(world().rank(), world().size());
    Archive::CellMoves moves{"numbers", own, {}, {}};
    for (int part = 0; part < archive.parts(); ++part) {
        const std::vector<int> there = archive.part_as<int>(part, "numbers");
        moves.cells.push_back(there.size());
        moves.from.emplace_back();
        for (std::size_t to = 0; to < own.size(); ++to)
            for (std::size_t from = 0; from < there.size(); ++from)
                if (there[from] == own[to]) moves.from.back().push_back({static_cast<int>(from), static_cast<int>(to)});
    }
    return moves;
}

TEST(ArchiveOfOtherRanks, GivesEachItsPart)
{
    for (const int ranks : {1, 2, 3, 5, 7}) {
        Archive archive = saved_by(ranks);
        if (archive.same_ranks()) continue;
        archive.move_cells(moves_of(archive));
        Object object;
        object.same = 0;
        object.none = {1};
        archive.within("object", [&] { object.keep(archive); });
        EXPECT_EQ(object.same, 7.5);
        EXPECT_EQ(object.maybe, 2);
        EXPECT_EQ(object.count, world().is_master() ? 10 * ranks + ranks * (ranks - 1) / 2 : 0);
        EXPECT_EQ(object.sums.number, world().is_master() ? 1.5 * ranks : 0);
        EXPECT_EQ(object.sums.more[0], world().is_master() ? ranks * (ranks - 1) / 2 : 0);
        EXPECT_EQ(object.largest, 3 * (ranks - 1));
        EXPECT_TRUE(object.none.empty());
        std::vector<double> expected;
        for (const int number : cells_of(world().rank(), world().size()))
            expected.insert(expected.end(), {number + 0.5, -double(number)});
        EXPECT_EQ(object.of_cells, expected) << ranks;
    }
}

TEST(ArchiveOfOtherRanks, GivesALargeEntryInPieces)
{
    const Archive archive = saved_by(5);
    std::vector<char> all;
    std::vector<std::size_t> sizes;
    archive.part_in_pieces(3, "object/of_cells", 24, [&](const std::vector<char>& piece) {
        sizes.push_back(piece.size());
        all.insert(all.end(), piece.begin(), piece.end());
    });
    EXPECT_EQ(sizes, (std::vector<std::size_t>{24, 8}));  // two cells of two numbers
    EXPECT_EQ(all, archive.part(3, "object/of_cells"));
}

TEST(ArchiveOfOtherRanks, MovesAddresses)
{
    for (const int ranks : {1, 3, 5}) {
        Archive archive = saved_by(ranks);
        archive.move_cells(moves_of(archive));
        std::vector<CellAddress> addresses;
        for (int number = 0; number < 10; ++number)
            addresses.push_back({number % ranks, number / ranks});
        addresses.push_back({});
        archive.within("inside", [&] { move_addresses(world(), archive, addresses); });  // wherever it is asked
        for (int number = 0; number < 10; ++number) {
            EXPECT_EQ(addresses[static_cast<std::size_t>(number)].rank, number % world().size());
            EXPECT_EQ(addresses[static_cast<std::size_t>(number)].cell, number / world().size());
        }
        EXPECT_FALSE(addresses[10].known());
    }
}

TEST(ArchiveOfOtherRanks, RefusesWhatIsNotAlike)
{
    Archive archive = saved_by(3);
    int own = 0;
    try {
        archive.keep("own", own);
        FAIL();
    } catch (const std::runtime_error& error) {
        EXPECT_NE(std::string(error.what()).find("own differs from rank to rank"), std::string::npos) << error.what();
    }
    EXPECT_THROW(archive.keep("nothing", own), std::runtime_error);
}

}  // namespace
