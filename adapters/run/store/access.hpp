// How a store is opened, and what goes wrong with it.
#pragma once

#include <functional>
#include <stdexcept>
#include <string>

namespace crossgrain::store {

/// The store cannot be opened, read or written: one line that names the directory and the cause.
class StoreError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// `read` changes nothing on disk, works where nothing can be written, and needs the directory;
/// for `read_if_there` a missing one is empty. `write_later` is `write` from the first use on, so
/// that a call which is refused before leaves the directory as it was.
enum class Access { read, read_if_there, write, write_later };

/// Takes a line that the user should see, e.g. that somebody else is writing.
using Note = std::function<void(const std::string&)>;

}  // namespace crossgrain::store
