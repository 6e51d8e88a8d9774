// Protects runs from each other: no two share a directory, a sweep takes only what nobody holds.
#include "adapters/process/scratch_directory.hpp"
#include "tests/support/temporary_directory.hpp"

#include <boost/test/unit_test.hpp>

#include <atomic>
#include <csignal>
#include <fstream>
#include <thread>
#include <vector>

#include <sys/wait.h>
#include <unistd.h>

namespace fs = std::filesystem;
using crossgrain::adapters::process::ScratchDirectory;
using crossgrain::adapters::process::sweep;
using crossgrain::tests::TemporaryDirectory;

namespace {

std::size_t entries_in(const fs::path& parent) {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(parent), fs::directory_iterator()));
}

/// What a process leaves that is killed while it uses a scratch directory.
fs::path left_by_a_killed_process(const fs::path& parent) {
    int pipe_ends[2];
    BOOST_TEST_REQUIRE(pipe(pipe_ends) == 0);
    const pid_t child = fork();
    if (child == 0) {
        const ScratchDirectory mine(parent, "killed");
        std::ofstream(mine.path() / "half-written") << "x";
        const std::string name = mine.path().string();
        (void)!write(pipe_ends[1], name.data(), name.size());
        pause();
        _exit(0);
    }
    char name[4096];
    const ssize_t length = read(pipe_ends[0], name, sizeof name);
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    close(pipe_ends[0]);
    close(pipe_ends[1]);
    BOOST_TEST_REQUIRE(length > 0);
    return std::string(name, static_cast<std::size_t>(length));
}

}  // namespace

BOOST_AUTO_TEST_CASE(directories_of_one_stem_differ_and_go_with_their_scope) {
    const TemporaryDirectory parent;
    {
        const ScratchDirectory one(parent.path() / "runs", "case"),
            other(parent.path() / "runs", "case");
        BOOST_TEST(one.path() != other.path());
        BOOST_TEST(fs::is_directory(one.path()));
        BOOST_TEST(fs::is_directory(other.path()));
        std::ofstream(one.path() / "file") << "x";
    }
    BOOST_TEST(entries_in(parent.path() / "runs") == 0u);
}

BOOST_AUTO_TEST_CASE(a_sweep_takes_what_a_killed_process_left_and_nothing_else) {
    const TemporaryDirectory parent;
    const fs::path left = left_by_a_killed_process(parent.path());
    BOOST_TEST_REQUIRE(fs::exists(left / "half-written"));
    fs::create_directories(parent.path() / "empty-123");  // killed before it was marked
    fs::create_directories(parent.path() / "somebody's");
    std::ofstream(parent.path() / "file") << "x";
    const ScratchDirectory in_use(parent.path(), "used");
    ScratchDirectory kept(parent.path(), "kept");
    std::ofstream(kept.path() / "log") << "x";
    kept.keep();
    sweep(parent.path());
    BOOST_TEST(!fs::exists(left));
    BOOST_TEST(!fs::exists(parent.path() / "empty-123"));
    BOOST_TEST(fs::exists(in_use.path() / "running"));
    BOOST_TEST(fs::is_directory(kept.path()));
    BOOST_TEST(fs::is_directory(parent.path() / "somebody's"));
    BOOST_TEST(fs::exists(parent.path() / "file"));
}

BOOST_AUTO_TEST_CASE(a_removal_that_is_cut_short_is_finished_by_the_next_sweep) {
    const TemporaryDirectory parent;
    const fs::path half = parent.path() / "case-1";
    constexpr std::size_t files = 20'000;
    fs::create_directories(half);
    for (std::size_t i = 0; i < files; ++i)
        std::ofstream(half / std::to_string(i)) << "x";
    std::ofstream(half / "running") << "x";
    const pid_t remover = fork();
    if (remover == 0) {
        sweep(parent.path());
        _exit(0);
    }
    while (entries_in(half) > files - 100) {
    }
    kill(remover, SIGKILL);
    waitpid(remover, nullptr, 0);
    BOOST_TEST(fs::exists(half / "running"));
    sweep(parent.path());
    BOOST_TEST(!fs::exists(half));
}

BOOST_AUTO_TEST_CASE(a_link_is_not_followed) {
    const TemporaryDirectory parent, elsewhere;
    std::ofstream(elsewhere.path() / "running") << "x";
    fs::create_directory_symlink(elsewhere.path(), parent.path() / "link-1");
    sweep(parent.path());
    BOOST_TEST(fs::exists(elsewhere.path() / "running"));
}

BOOST_AUTO_TEST_CASE(what_is_kept_replaces_what_was_kept_before) {
    const TemporaryDirectory parent;
    ScratchDirectory other(parent.path(), "case-b");
    other.keep();
    fs::path first;
    {
        ScratchDirectory scratch(parent.path(), "case");
        scratch.keep();
        first = scratch.path();
    }
    BOOST_TEST(fs::is_directory(first));
    ScratchDirectory second(parent.path(), "case");
    second.keep();
    BOOST_TEST(!fs::exists(first));
    BOOST_TEST(fs::is_directory(second.path()));
    BOOST_TEST(fs::is_directory(other.path()));
}

BOOST_AUTO_TEST_CASE(makers_and_sweepers_side_by_side_never_share_or_lose_a_directory) {
    const TemporaryDirectory parent;
    std::atomic<int> lost{0};
    std::vector<std::jthread> threads;
    for (int t = 0; t < 4; ++t) {
        threads.emplace_back([&] {
            for (int i = 0; i < 200; ++i) {
                const ScratchDirectory mine(parent.path(), "case");
                const fs::path file = mine.path() / "mine";
                if (fs::exists(file)) ++lost;  // somebody else's
                std::ofstream(file) << "x";
                sweep(parent.path());
                if (!fs::exists(file)) ++lost;
            }
        });
    }
    threads.clear();
    BOOST_TEST(lost == 0);
    BOOST_TEST(entries_in(parent.path()) == 0u);
}

BOOST_AUTO_TEST_CASE(an_impossible_parent_is_refused) {
    const TemporaryDirectory parent;
    std::ofstream(parent.path() / "file") << "x";
    BOOST_CHECK_THROW(ScratchDirectory(parent.path() / "file", "case"), fs::filesystem_error);
}
