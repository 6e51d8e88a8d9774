// What is compressed comes back to the byte, however it is cut; what is damaged, cut off or needs
// too much memory is refused.
#include "adapters/dump/zstd_file.hpp"
#include "native/base/errors.hpp"
#include "tests/support/temporary_directory.hpp"
#include "tests/support/zstd_text.hpp"

#include <boost/test/unit_test.hpp>
#include <zstd.h>

#include <cstdint>
#include <string>
#include <string_view>

using namespace crossgrain;
using adapters::dump::ZstdFile;
using adapters::dump::ZstdUnpacker;

namespace {

/// Longer than a window, and not all alike.
std::string long_text() {
    std::string text;
    std::uint32_t state = 1;
    while (text.size() < 5'000'000) {
        state = state * 1664525U + 1013904223U;
        text += std::to_string(state) + (state % 7 == 0 ? "\n" : " ");
    }
    return text;
}

std::string packed(const std::string& text) {
    const tests::TemporaryDirectory directory;
    tests::pack_into(directory.path() / "a.zst", text);
    return tests::bytes_of(directory.path() / "a.zst");
}

std::string refusal(const std::string& bytes) {
    try {
        (void)tests::unpacked(bytes);
    } catch (const TrajectoryError& error) {
        return error.what();
    }
    return "accepted";
}

}  // namespace

BOOST_AUTO_TEST_CASE(text_comes_back_to_the_byte) {
    const std::string text = long_text(), bytes = packed(text);
    BOOST_TEST(bytes.size() < text.size() * 6 / 10);
    for (const std::size_t piece : {std::size_t{1000}, std::size_t{1} << 20, bytes.size()})
        BOOST_TEST((tests::unpacked(bytes, piece) == text), piece);
    BOOST_TEST(tests::unpacked(packed("x"), 1) == "x");
    BOOST_TEST(tests::unpacked(packed("")) == "");
    // Two files joined by cat are a file.
    BOOST_TEST(tests::unpacked(packed("one ") + packed("two")) == "one two");
}

BOOST_AUTO_TEST_CASE(characters_one_by_one_are_a_text_too) {
    const tests::TemporaryDirectory directory;
    ZstdFile file(directory.path() / "a.zst");
    for (const char letter : std::string_view("letters"))
        file.put(letter);
    BOOST_TEST(file.finish());
    BOOST_TEST(tests::unpacked_file(directory.path() / "a.zst") == "letters");
}

BOOST_AUTO_TEST_CASE(a_file_that_nobody_ended_can_be_unpacked) {
    const tests::TemporaryDirectory directory;
    ZstdFile(directory.path() / "a.zst") << "as far as it went";
    BOOST_TEST(tests::unpacked_file(directory.path() / "a.zst") == "as far as it went");
}

BOOST_AUTO_TEST_CASE(what_cannot_be_written_is_said) {
    const tests::TemporaryDirectory directory;
    ZstdFile nowhere(directory.path() / "missing" / "a.zst");
    BOOST_TEST(!nowhere.good());
    BOOST_TEST(!nowhere.finish());
    if (!std::filesystem::exists("/dev/full")) return;
    ZstdFile full("/dev/full");
    full << "small enough for a buffer";
    BOOST_TEST(full.good());
    BOOST_TEST(!full.finish());
    BOOST_TEST(!full.finish());
    ZstdFile large("/dev/full");
    large << long_text();
    BOOST_TEST(!large.good());
}

BOOST_AUTO_TEST_CASE(damage_is_refused) {
    const std::string text = long_text(), whole = packed(text);
    BOOST_TEST(refusal(whole) == "accepted");
    BOOST_TEST(refusal(whole.substr(0, whole.size() / 2)) == "compressed dump is cut off");
    BOOST_TEST(refusal(whole.substr(0, whole.size() - 1)) == "compressed dump is cut off");
    BOOST_TEST(refusal("ITEM: TIMESTEP\n").starts_with("compressed dump is damaged (zstd: "));
    std::string checksum = whole;
    checksum.back() = static_cast<char>(checksum.back() ^ 1);
    BOOST_TEST(refusal(checksum).find("checksum") != std::string::npos);
    std::string content = whole;
    content[whole.size() / 2] = static_cast<char>(content[whole.size() / 2] ^ 1);
    BOOST_TEST(refusal(content).starts_with("compressed dump is damaged"));
    BOOST_TEST(refusal(whole + "behind it").starts_with("compressed dump is damaged"));
}

BOOST_AUTO_TEST_CASE(a_window_of_more_than_8_megabytes_is_refused) {
    const std::string text(20'000'000, 'a');
    const auto with_window = [&](int window) {
        ZSTD_CCtx* context = ZSTD_createCCtx();
        ZSTD_CCtx_setParameter(context, ZSTD_c_windowLog, window);
        ZSTD_CCtx_setParameter(context, ZSTD_c_contentSizeFlag, 0);
        std::string bytes(ZSTD_compressBound(text.size()), '\0');
        bytes.resize(ZSTD_compress2(context, bytes.data(), bytes.size(), text.data(), text.size()));
        ZSTD_freeCCtx(context);
        return bytes;
    };
    BOOST_TEST(refusal(with_window(23)) == "accepted");
    BOOST_TEST(refusal(with_window(24)).find("too much memory") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(what_the_sink_throws_ends_it) {
    // 100 MB of zeros in 10 kB: nobody has to take them all.
    const std::string bomb = packed(std::string(100'000'000, '\0'));
    BOOST_TEST(bomb.size() < 20'000u);
    std::size_t taken = 0;
    ZstdUnpacker unpacker([&](std::string_view piece) {
        taken += piece.size();
        throw TrajectoryError("enough");
    });
    BOOST_CHECK_THROW(unpacker.feed(bomb), TrajectoryError);
    BOOST_TEST(taken <= std::size_t{1} << 17);
}
