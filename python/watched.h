// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Long work that Python can watch and interrupt. It runs in a thread of its own without Python's
// lock, while the calling thread tells of progress and looks for Ctrl-C. So everything of Python is
// done by the thread that called.
#pragma once

#include <chrono>
#include <condition_variable>
#include <future>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include <clothfit/clothfit.h>
#include <pybind11/pybind11.h>

namespace clothfit::python {

namespace py = pybind11;

// What the work said last, until it is told.
class Said {
 public:
  void Say(const std::string& stage, double share) {
    const std::lock_guard<std::mutex> lock(mutex_);
    newest_ = {stage, share};
  }
  std::optional<std::pair<std::string, double>> Take() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return std::exchange(newest_, std::nullopt);
  }

 private:
  std::mutex mutex_;
  std::optional<std::pair<std::string, double>> newest_;
};

// work(callbacks), with `progress` called as progress(stage, share) where it is not None. Ctrl-C,
// or an exception of `progress`, stops the work and is raised once it has ended.
template <class Work>
auto RunWatched(const py::object& progress, const Work& work) {
  constexpr std::chrono::milliseconds kPause(20);
  std::atomic<bool> stop{false};
  Said said;
  Callbacks callbacks;
  callbacks.stop = &stop;
  callbacks.progress = [&said](const std::string& stage, double share) { said.Say(stage, share); };
  auto future = std::async(std::launch::async, [&] { return work(callbacks); });
  const auto wait = [&future](std::chrono::milliseconds time) {
    const py::gil_scoped_release release;
    return future.wait_for(time) == std::future_status::ready;
  };
  try {
    while (!wait(kPause)) {
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
      const auto newest = said.Take();
      if (newest && !progress.is_none()) progress(newest->first, newest->second);
    }
  } catch (...) {
    stop = true;
    const py::gil_scoped_release release;
    future.wait();
    throw;
  }
  return future.get();
}

}  // namespace clothfit::python
