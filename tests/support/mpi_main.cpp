// SPDX-License-Identifier: GPL-3.0-or-later
// The main function of tests that run on several ranks: one report, rank 0's, and every rank's failures.
#include <gtest/gtest.h>
#include <mpi.h>

#include <cstdio>
#include <string>

namespace {

/// Prints nothing but what failed, and on which rank.
class FailuresOfRank : public testing::EmptyTestEventListener {
public:
    explicit FailuresOfRank(int rank) : rank_(rank) {}

    // Kept from here: GoogleTest holds a lock while it reports a failure, so the test cannot be asked for then.
    void OnTestStart(const testing::TestInfo& test) override
    {
        test_ = std::string(test.test_suite_name()) + "." + test.name();
    }

    void OnTestPartResult(const testing::TestPartResult& result) override
    {
        if (!result.failed()) return;
        std::fprintf(stderr, "[rank %d] %s failed at %s:%d\n%s\n", rank_, test_.c_str(),
                     result.file_name() ? result.file_name() : "(unknown file)", result.line_number(),
                     result.message());
        std::fflush(stderr);
    }

private:
    int rank_;
    std::string test_;
};

}  // namespace

int main(int argc, char** argv)
{
    MPI_Init(&argc, &argv);
    testing::InitGoogleTest(&argc, argv);
    int rank = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    if (rank != 0) {
        auto& listeners = testing::UnitTest::GetInstance()->listeners();
        delete listeners.Release(listeners.default_result_printer());
        listeners.Append(new FailuresOfRank(rank));
    }

    const int failed_here = RUN_ALL_TESTS();
    int failed_anywhere = 0;
    MPI_Allreduce(&failed_here, &failed_anywhere, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
    MPI_Finalize();
    return failed_anywhere;
}
