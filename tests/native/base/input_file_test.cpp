// Input files: what may be read is read to its end, what cannot end or is no file is refused with
// its reason, and waiting for the writer of a pipe can be stopped.
#include "native/base/errors.hpp"
#include "native/base/input_file.hpp"
#include "tests/support/temporary_directory.hpp"

#include <boost/test/unit_test.hpp>

#include <array>
#include <fstream>
#include <string>
#include <string_view>
#include <thread>

#include <sys/stat.h>

using namespace crossgrain;
using namespace std::string_view_literals;

namespace {

std::string whole(const std::string& file, std::stop_token stop = {}) {
    InputFile input(file, "a text", std::move(stop));
    std::array<char, 7> block{};
    std::string text;
    while (const std::size_t got = input.read(block))
        text.append(block.data(), got);
    return text;
}

std::string refusal(const std::string& file) {
    try {
        (void)whole(file);
    } catch (const CaseError& error) {
        return error.what();
    }
    return "accepted";
}

}  // namespace

BOOST_AUTO_TEST_CASE(files_and_pipes_are_read_to_their_end) {
    const tests::TemporaryDirectory directory;
    const std::string file = directory.path() / "file", pipe = directory.path() / "pipe";
    const std::string text = "more than one block of text";
    std::ofstream(file) << text;
    BOOST_TEST(whole(file) == text);
    BOOST_TEST_REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
    const std::jthread writer([&] { std::ofstream(pipe) << text; });
    BOOST_TEST(whole(pipe) == text);
}

BOOST_AUTO_TEST_CASE(a_pipe_without_a_writer_is_left_when_asked_to) {
    const tests::TemporaryDirectory directory;
    const std::string pipe = directory.path() / "pipe";
    BOOST_TEST_REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
    std::stop_source stop;
    const std::jthread impatient([&] { stop.request_stop(); });
    BOOST_CHECK_THROW((void)whole(pipe, stop.get_token()), Interrupted);
}

BOOST_AUTO_TEST_CASE(what_is_no_file_is_refused) {
    const tests::TemporaryDirectory directory;
    const std::string path = directory.path();
    BOOST_TEST(refusal(path) == path + ": cannot be read, expected a text; it is a directory");
    BOOST_TEST(refusal("/dev/zero") ==
               "/dev/zero: cannot be read, expected a text; it is a device");
    BOOST_TEST(refusal(path + "/none").find("No such file") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(what_is_no_text_is_named) {
    const auto reason = [](std::string_view text) { return why_not_text(text).value_or("text"); };
    BOOST_TEST(reason("") == "text");
    BOOST_TEST(reason("ITEM: TIMESTEP\n") == "text");
    BOOST_TEST(reason("\xEF\xBB\xBFtext") == "text");
    BOOST_TEST(reason("\xC3\xA4") == "text");
    BOOST_TEST(reason("\x1f\x8b\x08") == "is compressed (gzip)");
    BOOST_TEST(reason("\x28\xb5\x2f\xfd") == "is compressed (zstd)");
    BOOST_TEST(reason("BZh9") == "is compressed (bzip2)");
    BOOST_TEST(reason("\xff\xfeI\0"sv) == "is UTF-16 text");
    BOOST_TEST(reason("\xfe\xff\0I"sv) == "is UTF-16 text");
    BOOST_TEST(reason("ab\0"sv) == "is binary (byte 3 is 0)");
}
