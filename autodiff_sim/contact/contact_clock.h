// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What contact costs a simulation, for benchmarks: processor time of this thread, added up over all
// simulations that it runs.
#pragma once

#include <ctime>

namespace clothfit {

struct ContactTimes {
  double detection = 0.0;  // s, finding pairs and checking motions
  double response = 0.0;   // s, forces and Jacobians of contact, patterns and matrices made anew
};
inline thread_local ContactTimes contact_times;

inline double ThreadSeconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// Adds the time of its life to *sum.
class ContactClock {
 public:
  explicit ContactClock(double* sum) : sum_(sum), start_(ThreadSeconds()) {}
  ~ContactClock() { *sum_ += ThreadSeconds() - start_; }
  ContactClock(const ContactClock&) = delete;
  ContactClock& operator=(const ContactClock&) = delete;

 private:
  double* sum_;
  double start_;
};

}  // namespace clothfit
