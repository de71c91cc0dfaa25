// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef RECORDER__SERVING__IDLER_IMPL_HPP_
#define RECORDER__SERVING__IDLER_IMPL_HPP_

#include <iostream>
#include <string>

#include "serving/idler_interface.hpp"

namespace serving
{

/// Stands in for the logic of idler: it writes its calls to stdout, for the test to read.
///
/// It refuses nothing, publishes every output, and fulfils every request at once.
class IdlerImpl
{
public:
  explicit IdlerImpl(
    [[maybe_unused]] const IdlerPassthrough & passthrough)
  {
  }

  bool configure(
    [[maybe_unused]] const IdlerConfig & config)
  {
    record("configure");
    record_changes(config);
    return true;
  }

  bool activate()
  {
    record("activate");
    return true;
  }

  void deactivate()
  {
    record("deactivate");
  }

  void cleanup() {record("cleanup");}

private:
  static void record(const std::string & call)
  {
    std::cout << "called " + call + "\n" << std::flush;
  }

  /// Record the parameters that have changed; at first, those that differ from the spec.
  void record_changes(
    [[maybe_unused]] const IdlerConfig & config)
  {
    config_ = config;
  }

  IdlerConfig config_;
};

}  // namespace serving

#endif  // RECORDER__SERVING__IDLER_IMPL_HPP_
