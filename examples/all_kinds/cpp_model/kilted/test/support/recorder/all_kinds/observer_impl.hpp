// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef SUPPORT__RECORDER__ALL_KINDS__OBSERVER_IMPL_HPP_
#define SUPPORT__RECORDER__ALL_KINDS__OBSERVER_IMPL_HPP_

#include <string>

#include "all_kinds/observer_interface.hpp"

#include "../recorder.hpp"

namespace all_kinds
{

/// Stands in for the logic of observer: it reports what it gets, and does what the test orders.
class ObserverImpl
{
public:
  explicit ObserverImpl(const ObserverPassthrough & passthrough)
  : passthrough_(passthrough), recorder_({
      {"sleep", [this](const std::string & seconds) {
          return to_json(passthrough_.sleep(std::stod(seconds)));
        }},
      {"log", logs(passthrough.log)},
      {"fail", [this](const std::string & reason) {
          passthrough_.fail(reason + "\nfor good");
          return "null";
        }},
    })
  {
  }

  bool configure(const ObserverConfig & config)
  {
    record(config);
    return recorder_.called("configure");
  }

  bool activate() {return recorder_.called("activate");}
  void deactivate() {recorder_.called("deactivate");}
  void cleanup() {recorder_.called("cleanup");}

  void update(ObserverData & data, const ObserverConfig & config)
  {
    recorder_.count("update", passthrough_.now().seconds());
    const auto words = recorder_.next("update");
    record(config);
    recorder_.take("in_status", encode(data.in_status), data.in_status_updated);
    recorder_.run(words);
  }

  void receive_pair(const observer_types::PairMessages & messages)
  {
    recorder_.called(
      "receive_pair",
      "[" + encode(messages.left) +
      ", " + encode(messages.right) + "]");
  }

private:
  /// Report the parameters, if they have changed.
  void record(const ObserverConfig & config)
  {
    std::string members;
    add(members, "limit", config.limit);
    const std::string text = "{" + members + "}";
    if (text != config_) {
      config_ = text;
      report("config", text);
    }
  }

  const ObserverPassthrough passthrough_;
  std::string config_;
  Recorder recorder_;
};

}  // namespace all_kinds

#endif  // SUPPORT__RECORDER__ALL_KINDS__OBSERVER_IMPL_HPP_
