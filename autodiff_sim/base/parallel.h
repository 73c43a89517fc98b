// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Pieces of work that do not depend on one another, done by several threads.
#pragma once

#include <functional>

namespace clothfit {

// `asked`, or as many as the machine runs at once where that is 0. Inside other parallel work 1:
// the cores are taken.
int NumThreads(int asked);

// The whole process runs no more threads at once than this from here on; 0: as the machine allows.
void LimitThreads(int most);

// While it lives, this thread's work counts as part of other parallel work.
class InsideParallelWork {
 public:
  InsideParallelWork();
  ~InsideParallelWork();
  InsideParallelWork(const InsideParallelWork&) = delete;
  InsideParallelWork& operator=(const InsideParallelWork&) = delete;

 private:
  bool before_;
};

// Calls work(piece, worker) for each piece from 0 to count - 1, in any order; worker is 0 to
// num_threads - 1 and does one piece at a time. Throws what the first failing piece threw, after
// the others have stopped. Where the system gives fewer threads than asked for, those do it all.
void ParallelFor(int count, int num_threads,
                 const std::function<void(int piece, int worker)>& work);

}  // namespace clothfit
