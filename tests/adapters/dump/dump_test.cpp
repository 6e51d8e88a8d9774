// Whole dumps are read to the same bits however they are cut; broken ones are refused with the
// line.
#include "adapters/dump/data_writer.hpp"
#include "adapters/dump/dump_reader.hpp"
#include "adapters/dump/dump_writer.hpp"
#include "native/base/errors.hpp"
#include "tests/support/kept_frames.hpp"
#include "tests/support/scenes.hpp"
#include "tests/support/temporary_directory.hpp"
#include "tests/support/zstd_text.hpp"

#include <boost/test/unit_test.hpp>

#include <chrono>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

using namespace crossgrain;
using adapters::dump::DumpReader;
using adapters::dump::DumpWriter;
using tests::KeptFrame;

namespace {

std::string written(const scene::Scene& scene, const std::vector<KeptFrame>& frames) {
    std::ostringstream out;
    DumpWriter writer(scene, out);
    for (const auto& frame : frames)
        writer(frame.view());
    return out.str();
}

/// Feeds `text` in pieces of `piece` bytes.
std::vector<KeptFrame> read(const scene::Scene& scene, const std::string& text,
                            std::size_t piece = std::string::npos) {
    std::vector<KeptFrame> frames;
    DumpReader reader(scene, [&](const scene::Frame& frame) { frames.emplace_back(frame); });
    for (std::size_t at = 0; at < text.size(); at += std::min(piece, text.size())) {
        reader.feed(std::string_view(text).substr(at, piece));
    }
    reader.finish();
    return frames;
}

/// A pair of grains in the open; the header of a frame and two rows.
scene::Scene pair() {
    return tests::head_on_pair();
}
const std::string header = "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\n"
                           "ITEM: BOX BOUNDS ss ss pp\n-5 5\n-5 5\n-1 1\n";
const std::string rows = "1 1 0.5 1 2 3\n2 1 -0.5 4 5 6\n";
const std::string columns = "ITEM: ATOMS id type xu yu vx vy\n";

std::string replaced(std::string text, const std::string& what, const std::string& by) {
    return text.replace(text.find(what), what.size(), by);
}

/// The reason why a dump of the pair is refused.
std::string refusal(const std::string& text) {
    try {
        (void)read(pair(), text);
    } catch (const TrajectoryError& error) {
        return error.what();
    }
    return "accepted";
}

}  // namespace

BOOST_AUTO_TEST_CASE(writing_and_reading_gives_the_same_bits) {
    const auto scene = tests::small_bed(1e-3);
    const auto frames = tests::reference_frames(scene);
    const auto text = written(scene, frames);
    const auto again = read(scene, text);
    BOOST_TEST(again.size() == 11u);
    BOOST_TEST(tests::largest_difference(frames, again) == 0.0);
    BOOST_TEST(again[3].step == scene.frame_every * 3);
    BOOST_TEST(again[3].time == static_cast<double>(again[3].step) * scene.dt);
    BOOST_TEST_REQUIRE(again[3].lid.has_value());
    BOOST_TEST(again[3].lid->height == frames[3].lid->height);
}

BOOST_AUTO_TEST_CASE(angular_velocities_are_kept_where_there_is_friction) {
    auto scene = tests::free_lid_collision();
    scene.contact.friction = scene::Friction{};
    auto frames = tests::reference_frames(tests::free_lid_collision());
    for (auto& frame : frames)
        frame.omega = {0.1 + frame.time, -5e-324};
    const auto text = written(scene, frames);
    BOOST_TEST(tests::largest_difference(frames, read(scene, text)) == 0.0);
    BOOST_TEST(text.find("ITEM: ATOMS id type xu yu vx vy omegaz\n") != std::string::npos);
    // Without friction the column is not asked for, with friction it must be there.
    BOOST_TEST(read(tests::free_lid_collision(), text)[0].omega.empty());
    auto frictional = pair();
    frictional.contact.friction = scene::Friction{};
    BOOST_CHECK_THROW((void)read(frictional, header + columns + rows), TrajectoryError);
}

BOOST_AUTO_TEST_CASE(data_files_hold_sizes_and_spins) {
    auto scene = pair();
    scene.contact.friction = scene::Friction{};
    scene.grains.diameters = {2.0, 0.1 + 0.2};
    scene.grains.masses = {1.0, 0.1};
    scene.initial.omega = {0.0, 1.0 / 3};
    const auto text = adapters::dump::data_file(scene);
    BOOST_TEST(text.find("\n2 1 0.30000000000000004 1 ") != std::string::npos);
    BOOST_TEST(text.find(" 0 0 0 0.33333333333333331\n") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(pieces_of_any_size_give_the_same_frames) {
    const auto scene = tests::small_bed(1e-3);
    const auto text = written(scene, tests::reference_frames(scene));
    const auto whole = read(scene, text);
    for (const std::size_t piece : {1u, 2u, 7u, 64u, 1000u}) {
        BOOST_TEST(tests::largest_difference(whole, read(scene, text, piece)) == 0.0);
    }
}

BOOST_AUTO_TEST_CASE(frames_are_passed_on_as_soon_as_they_are_complete) {
    int frames = 0;
    const auto scene = pair();
    DumpReader reader(scene, [&](const scene::Frame&) { ++frames; });
    const std::string text = header + columns + rows;
    reader.feed(std::string_view(text).substr(0, text.size() - 1));
    BOOST_TEST(frames == 0);
    reader.feed("\n");
    BOOST_TEST(frames == 1);
}

BOOST_AUTO_TEST_CASE(columns_are_found_by_name_and_rows_by_id) {
    const auto expected = read(pair(), header + columns + rows);
    BOOST_TEST(expected[0].x[0] == 0.5);
    BOOST_TEST(expected[0].vy[1] == 6.0);
    const std::vector<std::string> same = {
        "ITEM: ATOMS vy id radius vx xu yu \n6 2 1. 5 -0.5 4\n3 1 1. 2 0.5 1\n",
        "ITEM: ATOMS id xu yu vx vy fx fy\n1 0.5 1 2 3 x y\n2 -0.5 4 5 6 x y \n",
        "ITEM: ATOMS id x y vx vy\r\n1 0.5 1 2 3\r\n2 -0.5 4 5 6\r\n",
        "ITEM: ATOMS id x xu yu vx vy\n1 9 5e-1 1.0 2 3\n2 9 -0.5 4 5 6\n"};
    for (const auto& text : same) {
        BOOST_TEST(tests::largest_difference(expected, read(pair(), header + text)) == 0.0);
    }
    const std::string preamble = "ITEM: UNITS\nlj\nITEM: TIME\n0\n";
    BOOST_TEST(tests::largest_difference(expected,
                                         read(pair(), preamble + header + columns + rows)) == 0.0);
}

BOOST_AUTO_TEST_CASE(wrapped_positions_are_refused_along_a_period) {
    auto scene = pair();
    const std::string text = header + "ITEM: ATOMS id x yu vx vy\n1 0 0 0 0\n2 0 0 0 0\n";
    BOOST_CHECK_NO_THROW((void)read(scene, text));
    scene.periodic_x = 10;
    BOOST_CHECK_THROW((void)read(scene, replaced(text, "ss ss", "pp ss")), TrajectoryError);
    scene.periodic_x.reset();
    scene.periodic_y = 10;
    const std::string periodic = replaced(text, "ss ss", "ss pp");
    BOOST_CHECK_NO_THROW((void)read(scene, periodic));
    BOOST_CHECK_THROW((void)read(scene, replaced(periodic, "yu", "y")), TrajectoryError);
}

BOOST_AUTO_TEST_CASE(broken_dumps_are_refused_with_the_reason) {
    const std::string good = header + columns + rows;
    BOOST_TEST(refusal(good) == "accepted");
    BOOST_TEST(refusal("") == "dump holds no frame");
    BOOST_TEST(refusal(header + columns + "1 1 0.5 1 2 3\n") ==
               "dump ends in the middle of the frame at step 0 (after line 10)");
    BOOST_TEST(refusal(good.substr(0, good.size() - 1)) ==
               "dump ends in the middle of the frame at step 0 (after line 10)");
    BOOST_TEST(refusal(good + "ITEM: TIMESTEP\n") ==
               "dump ends in the middle of the frame 1 (after line 12)");
    BOOST_TEST(refusal(replaced(good, "ATOMS\n2", "ATOMS\n3")) ==
               "dump, line 4: frame at step 0 holds 3 atoms, 2 expected (2 grains)");
    BOOST_TEST(refusal(replaced(good, "xu", "xs")) ==
               "dump, line 9: column 'xu' is missing (found: id type xs yu vx vy)");
    BOOST_TEST(refusal(replaced(good, " vy", "")) ==
               "dump, line 9: column 'vy' is missing (found: id type xu yu vx)");
    BOOST_TEST(refusal(replaced(good, "-0.5", "nan")) ==
               "dump, line 11: 'nan' in column x is not finite");
    BOOST_TEST(refusal(replaced(good, "-0.5", "-inf")) ==
               "dump, line 11: '-inf' in column x is not finite");
    BOOST_TEST(refusal(replaced(good, "-0.5", "1e999")) ==
               "dump, line 11: '1e999' in column x is not a number");
    BOOST_TEST(refusal(replaced(good, "-0.5", "0.5a")) ==
               "dump, line 11: '0.5a' in column x is not a number");
    BOOST_TEST(refusal(replaced(good, " 5 6", " 5")) ==
               "dump, line 11: row '2 1 -0.5 4 5' has too few columns");
    BOOST_TEST(refusal(replaced(good, "\n2 1 -", "\n1 1 -")) ==
               "dump, line 11: id 1 appears twice in the frame at step 0");
    BOOST_TEST(refusal(replaced(good, "\n2 1 -", "\n3 1 -")) ==
               "dump, line 11: unknown id 3 (1 to 2 expected)");
    BOOST_TEST(refusal(replaced(good, "2 1 -0.5 4 5 6\n", "ITEM: TIMESTEP\n")) ==
               "dump, line 11: frame at step 0 has 1 rows, 2 expected");
    BOOST_TEST(refusal(replaced(good, "TIMESTEP\n0", "TIMESTEP\n0.5")) ==
               "dump, line 2: '0.5' is not a step");
    BOOST_TEST(
        refusal(good + "3 1 0 0 0 0\n").find("dump, line 12: '3 1 0 0 0 0' is out of place") == 0u);
    BOOST_TEST(refusal(columns + rows).find("dump, line 1: 'ITEM: ATOMS") == 0u);
    BOOST_TEST(refusal(replaced(good, "ITEM: NUMBER OF ATOMS\n2\n", "")).find("dump, line 3") ==
               0u);
}

BOOST_AUTO_TEST_CASE(what_is_no_text_is_refused_for_what_it_is) {
    using namespace std::string_literals;
    BOOST_TEST(refusal("\x1f\x8b\x08 compressed\n") ==
               "dump is compressed (gzip), not a LAMMPS text dump");
    BOOST_TEST(refusal("\x1f\x8b\x08") == "dump is compressed (gzip), not a LAMMPS text dump");
    BOOST_TEST(refusal("\xff\xfeI\0T\0"s) == "dump is UTF-16 text, not a LAMMPS text dump");
    BOOST_TEST(refusal("\0\0\0\0\n"s) == "dump is binary (byte 1 is 0), not a LAMMPS text dump");
    BOOST_TEST(refusal("\xEF\xBB\xBF" + header + columns + rows) == "accepted");
    const std::string escaped = refusal(header + columns + rows + "\x1b[2J\x07\n");
    BOOST_TEST(escaped.find("'\\x1b[2J\\x07' is out of place") != std::string::npos, escaped);
    BOOST_TEST(refusal(replaced(header + columns + rows, "-0.5", "\x1b[2J"))
                   .find("'\\x1b[2J' in column x is not a number") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_line_without_end_is_refused_when_it_is_too_long) {
    const std::string longest(adapters::dump::longest_line, 'x');
    for (const std::string& start : {std::string(), header + columns}) {
        std::size_t fed = 0;
        const auto scene = pair();
        DumpReader reader(scene, [](const scene::Frame&) {});
        reader.feed(start);
        const auto feed_on = [&] {
            for (; fed < 1'000'000; ++fed)
                reader.feed(longest.substr(0, 1000));
        };
        BOOST_CHECK_EXCEPTION(feed_on(), TrajectoryError, [](const auto& error) {
            const std::string text = error.what();
            return text.find("longer than 65536 bytes") != std::string::npos && text.size() < 300;
        });
        BOOST_TEST(fed < 70u);
    }
    // In one piece, with an end, and of zeros as a device has them.
    BOOST_TEST(refusal(header + columns + longest + "x\n").find("longer than") !=
               std::string::npos);
    BOOST_TEST(refusal(std::string(200'000, '\0')) ==
               "dump is binary (byte 1 is 0), not a LAMMPS text dump");
    // A comment-like column of that length is no reason to refuse.
    const std::string rest = " " + longest.substr(0, adapters::dump::longest_line - 20);
    BOOST_TEST(refusal(header + columns + replaced(rows, "2 3\n", "2 3" + rest + "\n")) ==
               "accepted");
}

BOOST_AUTO_TEST_CASE(a_header_is_not_repeated_without_end) {
    const std::string units = "ITEM: UNITS\nlj\n", time = "ITEM: TIME\n0\n";
    BOOST_TEST(refusal(units + time + header + columns + rows) == "accepted");
    BOOST_TEST(refusal(units + units).find("line 3: 'ITEM: UNITS' is out of place") !=
               std::string::npos);
    BOOST_TEST(refusal(time + time).find("line 3: 'ITEM: TIME' is out of place") !=
               std::string::npos);
    BOOST_TEST(refusal(header + columns + rows + "\n") ==
               "dump, line 12: a blank line is out of place");
}

BOOST_AUTO_TEST_CASE(kept_dumps_name_the_periods) {
    auto scene = tests::small_gas();
    scene.periodic_x = 10;
    scene.periodic_y = 14;
    const auto frame = tests::reference_frames(tests::small_gas(1e-2)).front();
    const std::string both = written(scene, {frame});
    BOOST_TEST(both.find("ITEM: BOX BOUNDS pp pp pp\n0 10\n0 14\n") != std::string::npos);
    scene.periodic_y.reset();
    BOOST_TEST(written(scene, {frame}).find("ITEM: BOX BOUNDS pp ss pp\n0 10\n") !=
               std::string::npos);
}

BOOST_AUTO_TEST_CASE(data_files_hold_no_text_from_outside) {
    auto scene = pair();
    const std::string plain = adapters::dump::data_file(scene);
    scene.name = "x\nshell touch pwned\n#";
    BOOST_TEST(adapters::dump::data_file(scene) == plain);
}

BOOST_AUTO_TEST_CASE(what_the_sink_throws_is_left_alone) {
    const auto scene = pair();
    DumpReader reader(scene, [](const scene::Frame&) { throw TrajectoryError("mine"); });
    BOOST_CHECK_EXCEPTION(reader.feed(header + columns + rows), TrajectoryError,
                          [](const auto& error) { return std::string(error.what()) == "mine"; });
}

BOOST_AUTO_TEST_CASE(a_free_lid_is_the_last_row) {
    const auto scene = tests::free_lid_collision();
    const std::string with_lid =
        replaced(header, "ATOMS\n2", "ATOMS\n3") + columns + "3 2 0 2.5 0 -1\n" + rows;
    const auto frames = read(scene, with_lid);
    BOOST_TEST(frames[0].x.size() == 2u);
    BOOST_TEST(frames[0].lid->height == 2.5);
    BOOST_TEST(frames[0].lid->velocity == -1.0);
    BOOST_CHECK_THROW((void)read(scene, header + columns + rows), TrajectoryError);
}

BOOST_AUTO_TEST_CASE(files_are_read_like_streams) {
    const tests::TemporaryDirectory directory;
    const auto scene = tests::small_gas(1e-3);
    const auto frames = tests::reference_frames(scene);
    std::ofstream(directory.path() / "dump.txt") << written(scene, frames);
    std::vector<KeptFrame> again;
    adapters::dump::read_dump_file(directory.path() / "dump.txt", scene,
                                   [&](const scene::Frame& frame) { again.emplace_back(frame); });
    BOOST_TEST(tests::largest_difference(frames, again) == 0.0);
    tests::pack_into(directory.path() / "dump.txt.zst", written(scene, frames));
    again.clear();
    adapters::dump::read_dump_file(directory.path() / "dump.txt.zst", scene,
                                   [&](const scene::Frame& frame) { again.emplace_back(frame); });
    BOOST_TEST(tests::largest_difference(frames, again) == 0.0);
    std::filesystem::copy_file(directory.path() / "dump.txt", directory.path() / "plain.zst");
    BOOST_CHECK_THROW(
        adapters::dump::read_dump_file(directory.path() / "plain.zst", scene, [](const auto&) {}),
        TrajectoryError);
    BOOST_CHECK_THROW(
        adapters::dump::read_dump_file(directory.path() / "missing", scene, [](const auto&) {}),
        CaseError);
}

BOOST_AUTO_TEST_CASE(data_file_holds_only_the_types_in_use) {
    auto scene = tests::small_bed();
    BOOST_TEST(adapters::dump::atom_types(scene).lid == 2);
    scene.initial.frozen.assign(scene.grain_count(), false);
    BOOST_TEST(adapters::dump::atom_types(scene).frozen == 0);
    scene.initial.frozen[4] = true;
    const auto types = adapters::dump::atom_types(scene);
    BOOST_TEST(types.frozen == 2);
    BOOST_TEST(types.lid == 3);
    const std::string text = adapters::dump::data_file(scene);
    BOOST_TEST(text.find("19 atoms\n3 atom types\n") != std::string::npos);
    BOOST_TEST(text.find("\n5 2 2 1 ") != std::string::npos);
    BOOST_TEST(text.find("\n5 0 0 0 0 0 0\n") != std::string::npos);
    BOOST_TEST(text.find("\n19 3 2 1 ") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(reading_is_fast_enough_for_a_pipe) {
    const auto scene = tests::small_gas();
    std::string text;
    const auto one = written(scene, {tests::reference_frames(tests::small_gas(1e-2)).back()});
    while (text.size() < (std::size_t{20} << 20))
        text += one;
    double sum = 0;
    DumpReader reader(scene, [&](const scene::Frame& frame) { sum += frame.x[0]; });
    const auto start = std::chrono::steady_clock::now();
    reader.feed(text);
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    const double rate = static_cast<double>(text.size()) / 1e6 / elapsed.count();
    BOOST_TEST_MESSAGE("parsing: " << rate << " MB/s");
    BOOST_TEST(sum != 0.0);
    // A debug build with sanitizers on a busy machine reaches a tenth of the release build's rate.
    BOOST_TEST(rate > 5);
}
