#include "adapters/run/kept_frames.hpp"

#include "adapters/process/file_digests.hpp"
#include "adapters/run/whole_file.hpp"
#include "native/base/bounded_json.hpp"
#include "native/base/errors.hpp"
#include "native/base/file_stem.hpp"
#include "native/base/printable.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <system_error>
#include <vector>

namespace crossgrain::run {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char* record_name = "frames.json";
constexpr int record_format = 1;

/// The digits of the key that the name of a directory has.
std::string mark_of(const std::string& key) {
    constexpr std::size_t digits = 12;
    return "-" + key.substr(0, digits);
}

/// Digests are not remembered: a dump is read once.
std::string digest_of(const fs::path& file, const std::stop_token& stop) {
    return adapters::process::FileDigests({}).of(file, stop);
}

/// No more than a record takes. Throws std::invalid_argument for anything else.
std::string text_of_record(const fs::path& file) {
    constexpr std::uintmax_t longest_record = 10'000;  // bytes
    std::error_code error;
    if (!fs::is_regular_file(file, error)) {
        throw std::invalid_argument(fmt::format("{} is no regular file", record_name));
    }
    if (fs::file_size(file, error) > longest_record || error) {
        throw std::invalid_argument(fmt::format("{} is longer than a record", record_name));
    }
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

double seconds_in(const json& record, const char* name) {
    const double seconds = record.at(name).get<double>();
    if (!std::isfinite(seconds) || seconds < 0) {
        throw std::invalid_argument(fmt::format("{} has {} = {}", record_name, name, seconds));
    }
    return seconds;
}

void require_identity(const json& record, const FramesIdentity& frames) {
    if (record.at("format").get<int>() != record_format) {
        throw std::invalid_argument(
            fmt::format("{} has another format than {}", record_name, record_format));
    }
    for (const auto& [name, expected] :
         {std::pair{"frames", frames.key}, {"code", frames.code}, {"version", frames.version}}) {
        const auto found = record.at(name).get<std::string>();
        if (found != expected) {
            throw std::invalid_argument(fmt::format("{} is of {} {}, not {}", record_name, name,
                                                    printable(found), printable(expected)));
        }
    }
}

/// Whole, and as it was recorded: looked at before anything of it is unpacked.
void require_dump(const json& record, const fs::path& dump, const std::stop_token& stop) {
    const std::string name = dump.filename().string();
    std::error_code error;
    if (!fs::is_regular_file(dump, error)) {
        throw std::invalid_argument(fmt::format("{} is no regular file", name));
    }
    const auto recorded = record.at("bytes").get<std::uintmax_t>();
    const auto found = fs::file_size(dump, error);
    if (error || found != recorded) {
        throw std::invalid_argument(
            fmt::format("{} holds {} bytes, {} were recorded", name, found, recorded));
    }
    if (digest_of(dump, stop) != record.at("sha256").get<std::string>()) {
        throw std::invalid_argument(fmt::format("{} was changed since it was recorded", name));
    }
}

/// Throws what describes the fault: std::exception of several kinds.
KeptFrames frames_in(const fs::path& directory, const FramesIdentity& frames,
                     const std::stop_token& stop) {
    const json record = bounded_json(text_of_record(directory / record_name));
    require_identity(record, frames);
    KeptFrames kept{
        .dump = directory / adapters::kept_dump_name,
        .cost = {.cpu_s = seconds_in(record, "cpu_s"), .wall_s = seconds_in(record, "wall_s")}};
    require_dump(record, kept.dump, stop);
    return kept;
}

/// Directories with this mark that have a record; that of a run without whole frames has none.
std::vector<fs::path> directories_with(const std::string& mark, const fs::path& runs) {
    std::vector<fs::path> found;
    std::error_code error;
    for (fs::directory_iterator entry(runs, error), end; !error && entry != end;
         entry.increment(error)) {
        const std::string name = entry->path().filename().string();
        if (name.find(mark + "-") == std::string::npos) continue;
        std::error_code missing;
        if (fs::exists(fs::symlink_status(entry->path() / record_name, missing)))
            found.push_back(entry->path());
    }
    std::ranges::sort(found);
    return found;
}

}  // namespace

std::string frames_directory_stem(const std::string& name, const FramesIdentity& frames,
                                  std::int64_t replica) {
    constexpr std::size_t readable = 100;
    return file_stem({name, frames.code, fmt::format("{}", replica + 1)}, readable) +
           mark_of(frames.key);
}

void record_frames(const fs::path& directory, const FramesIdentity& frames,
                   const adapters::RunCost& cost) {
    const fs::path dump = directory / adapters::kept_dump_name;
    const json record{{"format", record_format},      {"frames", frames.key},
                      {"code", frames.code},          {"version", frames.version},
                      {"cpu_s", cost.cpu_s},          {"wall_s", cost.wall_s},
                      {"bytes", fs::file_size(dump)}, {"sha256", digest_of(dump, {})}};
    write_whole_file(directory / record_name, record.dump(1) + "\n");
}

std::string frames_refusal(const fs::path& directory, const std::string& reason) {
    constexpr std::size_t longest_path = 1000;
    return fmt::format("warning: the frames kept in {} cannot be measured again ({}); the code is "
                       "run instead",
                       printable(directory.string(), longest_path), printable(reason));
}

std::optional<KeptFrames> find_frames(const fs::path& runs, const FramesIdentity& frames,
                                      Monitor& monitor, const std::stop_token& stop) {
    for (const auto& directory : directories_with(mark_of(frames.key), runs)) {
        try {
            return frames_in(directory, frames, stop);
        } catch (const Interrupted&) {
            throw;
        } catch (const std::exception& error) {  // what reads JSON throws several kinds
            monitor.note(frames_refusal(directory, error.what()));
        }
    }
    return std::nullopt;
}

}  // namespace crossgrain::run
