// Copyright 2019 My Company
// SPDX-License-Identifier: GPL-3.0-only

#ifndef CONTACT_EVALUATE_HARNESS_HPP_
#define CONTACT_EVALUATE_HARNESS_HPP_

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "./fakes.hpp"
#include "contact_analysis/contact_evaluate_impl.hpp"

namespace contact_analysis
{

/// The logic of contact_evaluate, fakes in the place of ROS, and a clock.
///
/// With messages received, a cycle is `harness.in_NAME(message).run_cycle().out_NAME`.
struct ContactEvaluateHarness
{
  ContactEvaluateHarness()
  : impl(connected())
  {
  }

  ContactEvaluateHarness(const ContactEvaluateHarness &) = delete;

  /// Pass a message to the next cycle.
  ContactEvaluateHarness & in_cop(
    const contact_evaluate_types::InCop & message)
  {
    data.in_cop = message;
    data.in_cop_updated = true;
    return *this;
  }

  /// Run one cycle as the node does.
  const ContactEvaluateData & run_cycle()
  {
    impl.update(data, config);
    data.in_cop_updated = false;
    return data;
  }

  Time time;
  bool stopped = false;
  std::vector<std::string> log;
  ContactEvaluateConfig config;
  ContactEvaluateData data;
  ContactEvaluatePassthrough passthrough;
  std::shared_ptr<FakePublisher<contact_evaluate_types::PubPlotLearnCop>> pub_plot_learn_cop =
    fake<FakePublisher>(passthrough.pub_plot_learn_cop);
  ContactEvaluateImpl impl;

private:
  const ContactEvaluatePassthrough & connected()
  {
    passthrough.log = Logger(
      [this](Logger::Level, const std::string & text, const Logger::Place &) {
        log.push_back(text);
      });
    passthrough.now = [this] {return time;};
    passthrough.sleep = [this](double seconds) {
        if (!stopped) {
          time = Time(time.nanoseconds() + static_cast<std::int64_t>(seconds * 1e9));
        }
        return !stopped;
      };
    return passthrough;
  }
};

}  // namespace contact_analysis

#endif  // CONTACT_EVALUATE_HARNESS_HPP_
