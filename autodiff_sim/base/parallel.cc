// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "autodiff_sim/base/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace clothfit {

namespace {

thread_local bool is_inside = false;
std::atomic<int> most_threads = 0;

}  // namespace

InsideParallelWork::InsideParallelWork() : before_(is_inside) { is_inside = true; }
InsideParallelWork::~InsideParallelWork() { is_inside = before_; }

int NumThreads(int asked) {
  if (is_inside) return 1;
  const int all = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  const int threads = asked > 0 ? asked : all, most = most_threads;
  return most > 0 ? std::min(threads, most) : threads;
}

void LimitThreads(int most) { most_threads = most; }

void ParallelFor(int count, int num_threads,
                 const std::function<void(int piece, int worker)>& work) {
  if (std::min(count, num_threads) <= 1) {
    for (int piece = 0; piece < count; ++piece) work(piece, 0);
    return;
  }
  std::atomic<int> next = 0;
  std::exception_ptr failure;
  std::mutex mutex;
  const auto run = [&](int worker) {
    const InsideParallelWork inside;
    try {
      for (int piece = next++; piece < count; piece = next++) work(piece, worker);
    } catch (...) {
      next = count;
      const std::lock_guard<std::mutex> lock(mutex);
      if (failure == nullptr) failure = std::current_exception();
    }
  };
  std::vector<std::thread> threads;
  threads.reserve(static_cast<std::size_t>(std::min(count, num_threads)));
  try {
    for (int worker = 1; worker < std::min(count, num_threads); ++worker)
      threads.emplace_back(run, worker);
  } catch (...) {  // the system gives no more: those that began do it all
  }
  run(0);
  for (std::thread& thread : threads) thread.join();
  if (failure != nullptr) std::rethrow_exception(failure);
}

}  // namespace clothfit
