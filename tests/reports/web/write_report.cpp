// Writes the report pages of a document, so that the browser tests see what the program writes.
//   write_report DOCUMENT.json DIRECTORY ASSETS
#include <exception>
#include <fstream>

#include <fmt/format.h>

#include "reports/web/web_report.hpp"

int main(int argc, char** argv) {
    if (argc != 4) {
        fmt::print(stderr, "usage: write_report DOCUMENT.json DIRECTORY ASSETS\n");
        return 2;
    }
    try {
        std::ifstream in(argv[1]);
        crossgrain::reports::write_web_report(nlohmann::json::parse(in), argv[2], argv[3]);
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 1;
    }
    return 0;
}
