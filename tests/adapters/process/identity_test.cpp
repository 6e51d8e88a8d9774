// A program is what its bytes are: each change that could change a result changes the digest.
#include "adapters/process/file_digests.hpp"
#include "adapters/process/find_program.hpp"
#include "adapters/process/program_identity.hpp"
#include "adapters/process/shared_libraries.hpp"
#include "native/base/digest.hpp"
#include "native/base/errors.hpp"
#include "tests/support/temporary_directory.hpp"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <stop_token>
#include <string>
#include <system_error>
#include <vector>

namespace fs = std::filesystem;
namespace process = crossgrain::adapters::process;
using crossgrain::sha256;
using crossgrain::tests::TemporaryDirectory;
using process::FileDigests;

namespace {

std::string digest_of(const fs::path& program, const std::vector<fs::path>& further = {}) {
    return process::identify({.program = program, .further_files = further}, {}).digest;
}

fs::path write(const fs::path& file, const std::string& text) {
    std::ofstream(file) << text;
    fs::permissions(file, fs::perms::owner_all);
    return file;
}

}  // namespace

BOOST_AUTO_TEST_CASE(sha256_of_texts) {
    // FIPS 180-2, appendix B.
    BOOST_TEST(sha256("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    crossgrain::Sha256 pieces;
    pieces.add("a");
    pieces.add("");
    pieces.add("bc");
    BOOST_TEST(pieces.hex() == sha256("abc"));
}

BOOST_AUTO_TEST_CASE(a_wrapper_is_also_what_it_starts) {
    const TemporaryDirectory directory;
    const auto real = write(directory.path() / "lmp-real", "#!/bin/sh\necho 1\n");
    const auto data = directory.path() / "data";
    std::ofstream(data) << "1";
    const auto wrapper = write(directory.path() / "lmp", "#!/bin/sh\n# see " + data.string() +
                                                             "\nOMP_NUM_THREADS=1 exec \"" +
                                                             real.string() + "\" \"$@\"\n");
    const auto before = digest_of(wrapper);
    std::ofstream(data) << "2";  // no program
    BOOST_TEST(digest_of(wrapper) == before);
    write(real, "#!/bin/sh\necho 2\n");
    BOOST_TEST(digest_of(wrapper) != before);
    // A file that is sourced is a script without a first line.
    const auto library = directory.path() / "settings.sh";
    std::ofstream(library) << "start() { exec " << real.string() << "; }\n";
    const auto sourcing = write(directory.path() / "sourcing",
                                "#!/bin/sh\n. " + library.string() + "\nstart \"$@\"\n");
    const auto first = digest_of(sourcing);
    write(real, "#!/bin/sh\necho 3\n");
    const auto second = digest_of(sourcing);
    BOOST_TEST(first != second);
    std::ofstream(library) << "start() { exec lmp; }\n";
    BOOST_TEST(digest_of(sourcing) != second);
    // One that starts itself comes to an end.
    BOOST_TEST(digest_of(write(real, "#!/bin/sh\nexec " + real.string() + "\n")).size() == 64);
}

BOOST_AUTO_TEST_CASE(a_script_is_its_text_and_its_interpreter) {
    const TemporaryDirectory directory;
    const auto script = write(directory.path() / "code", "#!/bin/sh\nexec lmp -var gamma 0.1\n");
    const auto before = digest_of(script);
    BOOST_TEST(before.size() == 64);
    BOOST_TEST(digest_of(script) == before);
    // One parameter, at the same length.
    write(script, "#!/bin/sh\nexec lmp -var gamma 0.2\n");
    BOOST_TEST(digest_of(script) != before);
    write(script, "#!/bin/sh\nexec lmp -var gamma 0.1\n");
    BOOST_TEST(digest_of(script) == before);
}

BOOST_AUTO_TEST_CASE(an_interpreter_that_changes_is_another_program) {
    const TemporaryDirectory directory;
    const auto interpreter = write(directory.path() / "interpreter", "#!/bin/sh\n");
    const auto script =
        write(directory.path() / "script", "#!" + interpreter.string() + "\nsame text\n");
    const auto before = digest_of(script);
    write(interpreter, "#!/bin/sh\nexport LMP_GAMMA=2\n");
    BOOST_TEST(digest_of(script) != before);
    // "env" finds it on PATH.
    write(script, "#!/usr/bin/env " + interpreter.string() + "\nsame text\n");
    const auto by_env = digest_of(script);
    write(interpreter, "#!/bin/sh\n");
    BOOST_TEST(digest_of(script) != by_env);
    // A script that is its own interpreter ends.
    write(script, "#!" + script.string() + "\n");
    BOOST_TEST(digest_of(script).size() == 64);
}

BOOST_AUTO_TEST_CASE(links_are_followed_and_places_do_not_matter) {
    const TemporaryDirectory directory;
    const auto text = "#!/bin/sh\n";
    const auto script = write(directory.path() / "code", text);
    fs::create_symlink(script, directory.path() / "link");
    const auto by_link = process::identify({.program = directory.path() / "link"}, {});
    BOOST_TEST(by_link.program == fs::canonical(script));
    BOOST_TEST(by_link.digest == digest_of(script));
    fs::create_directory(directory.path() / "elsewhere");
    BOOST_TEST(digest_of(write(directory.path() / "elsewhere/code", text)) == by_link.digest);
}

BOOST_AUTO_TEST_CASE(further_files_count) {
    const TemporaryDirectory directory;
    const auto script = write(directory.path() / "code", "#!/bin/sh\n");
    const auto module = write(directory.path() / "module.py", "gamma = 1\n");
    const auto before = digest_of(script, {module});
    BOOST_TEST(before != digest_of(script));
    write(module, "gamma = 2\n");
    BOOST_TEST(digest_of(script, {module}) != before);
    BOOST_CHECK_THROW((void)digest_of(script, {directory.path() / "none"}), std::system_error);
}

BOOST_AUTO_TEST_CASE(shared_libraries_of_an_executable) {
    const auto executable = fs::canonical(process::find_program("sort").value());
    const auto loader = process::loader_of(executable);
    BOOST_TEST_REQUIRE(loader.has_value());
    const auto libraries = process::shared_libraries(*loader, executable, {}, {}, {});
    BOOST_TEST(std::ranges::all_of(libraries, [](const auto& path) { return fs::exists(path); }));
    BOOST_TEST(std::ranges::any_of(libraries, [](const auto& path) {
        return path.filename().string().starts_with("libc.so");
    }));
    BOOST_TEST(!process::loader_of("/etc/passwd"));
    BOOST_CHECK_THROW((void)process::loader_of("/no/such/file"), std::system_error);
}

BOOST_AUTO_TEST_CASE(a_library_that_changes_is_another_program) {
    // LD_LIBRARY_PATH puts a copy first; a byte behind its end changes nothing else.
    const TemporaryDirectory directory;
    const auto executable = fs::canonical("/proc/self/exe");
    const auto libraries =
        process::shared_libraries(process::loader_of(executable).value(), executable, {}, {}, {});
    const auto crypto = std::ranges::find_if(libraries, [](const auto& path) {
        return path.filename().string().starts_with("libcrypto");
    });
    BOOST_TEST_REQUIRE((crypto != libraries.end()));
    const auto copy = directory.path() / crypto->filename();
    fs::copy_file(fs::canonical(*crypto), copy);
    const auto digest = [&] {
        return process::identify(
                   {.program = executable,
                    .extra_environment = {"LD_LIBRARY_PATH=" + directory.path().string()}},
                   {})
            .digest;
    };
    const auto before = digest();
    std::ofstream(copy, std::ios::app) << '\0';
    BOOST_TEST(digest() != before);
}

BOOST_AUTO_TEST_CASE(a_missing_library_is_named) {
    const TemporaryDirectory directory;
    const auto executable = fs::canonical("/proc/self/exe");
    const auto broken = write(directory.path() / "libcrypto.so.3", "no library");
    BOOST_CHECK_EXCEPTION(
        (void)process::shared_libraries(process::loader_of(executable).value(), executable, {},
                                        {"LD_LIBRARY_PATH=" + directory.path().string()}, {}),
        std::system_error, [](const std::system_error& error) {
            return std::string(error.what()).find("libcrypto.so.3") != std::string::npos;
        });
}

BOOST_AUTO_TEST_CASE(digests_are_remembered_while_nothing_changes) {
    const TemporaryDirectory directory;
    const auto memory = directory.path() / "deep/below/digests";
    const fs::path file = fs::canonical(process::find_program("sort").value());
    std::string digest;
    {
        FileDigests digests(memory);
        digest = digests.of(file, {});
    }
    std::ifstream in(memory);
    std::string line;
    BOOST_TEST_REQUIRE(static_cast<bool>(std::getline(in, line)));
    BOOST_TEST(line.starts_with(digest + ' '));
    BOOST_TEST(line.ends_with(' ' + file.string()));
    // What is remembered is used: a planted one comes back.
    line.replace(0, digest.size(), std::string(64, 'a'));
    std::ofstream(memory) << "damaged\n" << std::string(70, 'b') << "\n\n" << line << "\nend";
    BOOST_TEST(FileDigests(memory).of(file, {}) == std::string(64, 'a'));
    // But not for a file with another stamp, nor from a line that is none.
    line[70] = line[70] == '1' ? '2' : '1';
    std::ofstream(memory) << line << '\n';
    BOOST_TEST(FileDigests(memory).of(file, {}) == digest);
    line[3] = 'x';
    std::ofstream(memory) << line << '\n';
    BOOST_TEST(FileDigests(memory).of(file, {}) == digest);
    fs::remove(memory);
    fs::create_directory(memory);
    BOOST_TEST(FileDigests(memory).of(file, {}) == digest);
    BOOST_TEST(FileDigests({}).of(file, {}) == digest);
}

BOOST_AUTO_TEST_CASE(a_file_that_has_just_changed_is_not_remembered) {
    const TemporaryDirectory directory;
    const auto memory = directory.path() / "digests";
    const auto file = write(directory.path() / "file", "one");
    {
        FileDigests digests(memory);
        BOOST_TEST(digests.of(file, {}) == sha256("one"));
    }
    BOOST_TEST(!fs::exists(memory));
    std::ofstream(file) << "two";
    BOOST_TEST(FileDigests(memory).of(file, {}) == sha256("two"));
    BOOST_CHECK_THROW((void)FileDigests(memory).of(directory.path() / "none", {}),
                      std::system_error);
}

BOOST_AUTO_TEST_CASE(a_stop_request_is_heard) {
    std::stop_source stop;
    stop.request_stop();
    const auto program = process::find_program("sort").value();
    BOOST_CHECK_THROW((void)FileDigests({}).of(program, stop.get_token()), crossgrain::Interrupted);
    BOOST_CHECK_THROW((void)process::identify({.program = program}, stop.get_token()),
                      crossgrain::Interrupted);
}
