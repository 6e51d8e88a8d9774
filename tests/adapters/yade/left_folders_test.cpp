// What a killed YADE leaves goes, and nothing else.
#include "adapters/yade/left_folders.hpp"
#include "tests/support/temporary_directory.hpp"

#include <boost/test/unit_test.hpp>

#include <chrono>
#include <fstream>

namespace fs = std::filesystem;
using crossgrain::adapters::yade::remove_old_folders;
using crossgrain::tests::TemporaryDirectory;

namespace {

fs::path folder(const TemporaryDirectory& parent, const std::string& name, bool old = true) {
    const fs::path path = parent.path() / name;
    fs::create_directory(path);
    if (old) fs::last_write_time(path, fs::file_time_type::clock::now() - std::chrono::minutes(1));
    return path;
}

}  // namespace

BOOST_AUTO_TEST_CASE(only_old_empty_folders_of_that_name_go) {
    const TemporaryDirectory parent;
    const auto left = folder(parent, "yade-aB3x9Z"), young = folder(parent, "yade-young1", false);
    const auto longer = folder(parent, "yade-aB3x9Zz"), other = folder(parent, "mine-aB3x9Z");
    const auto full = folder(parent, "yade-full12");
    std::ofstream(full / "saved.xml") << "x";
    fs::last_write_time(full, fs::file_time_type::clock::now() - std::chrono::minutes(1));
    remove_old_folders(parent.path());
    for (const auto& stays : {young, longer, other, full})
        BOOST_TEST(fs::exists(stays), stays.string());
    BOOST_TEST(!fs::exists(left));
    remove_old_folders(parent.path() / "missing");
}
