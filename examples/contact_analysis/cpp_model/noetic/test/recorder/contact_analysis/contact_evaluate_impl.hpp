// Copyright 2019 My Company
// SPDX-License-Identifier: GPL-3.0-only

#ifndef RECORDER__CONTACT_ANALYSIS__CONTACT_EVALUATE_IMPL_HPP_
#define RECORDER__CONTACT_ANALYSIS__CONTACT_EVALUATE_IMPL_HPP_

#include <chrono>
#include <iostream>
#include <string>

#include "contact_analysis/contact_evaluate_interface.hpp"

namespace contact_analysis
{

/// Stands in for the logic of contact_evaluate: it writes its calls to stdout, for the test to
/// read.
///
/// It refuses nothing, publishes every output, and fulfils every request at once.
class ContactEvaluateImpl
{
public:
  explicit ContactEvaluateImpl(
    [[maybe_unused]] const ContactEvaluatePassthrough & passthrough)
  : passthrough_(passthrough)
  {
  }

  bool configure(
    [[maybe_unused]] const ContactEvaluateConfig & config)
  {
    record("configure");
    record_changes(config);
    return true;
  }

  bool activate()
  {
    publish();
    updates_ = 0;
    start_ = Clock::now();
    record("activate");
    return true;
  }

  void update(
    [[maybe_unused]] ContactEvaluateData & data,
    [[maybe_unused]] const ContactEvaluateConfig & config)
  {
    if (++updates_ == 1) {
      record("update");
    }
    if (data.in_cop_updated) {
      record("in_cop");
    }
    record_changes(config);
  }

  void serve_load(
    const contact_evaluate_types::LoadService::Request & /* request */,
    contact_evaluate_types::LoadService::Response & /* response */)
  {
    record("serve_load");
  }

  void serve_store(
    const contact_evaluate_types::StoreService::Request & /* request */,
    contact_evaluate_types::StoreService::Response & /* response */)
  {
    record("serve_store");
  }

  void execute_learn(
    Goal<contact_evaluate_types::LearnAction> & goal)
  {
    record("execute_learn");
    goal.succeed();
  }

  void execute_evaluate(
    Goal<contact_evaluate_types::EvaluateAction> & goal)
  {
    record("execute_evaluate");
    goal.succeed();
  }

  void deactivate()
  {
    const std::chrono::duration<double> seconds = Clock::now() - start_;
    record("rate " + std::to_string(updates_ / seconds.count()));
    updates_ = 0;
    record("deactivate");
    publish();
  }

  void cleanup() {record("cleanup");}

private:
  using Clock = std::chrono::steady_clock;

  static void record(const std::string & call)
  {
    std::cout << "called " + call + "\n" << std::flush;
  }

  /// Record the parameters that have changed; at first, those that differ from the spec.
  void record_changes(
    [[maybe_unused]] const ContactEvaluateConfig & config)
  {
    if (config.samples != config_.samples) {
      record("config.samples");
    }
    if (config.pub_sample != config_.pub_sample) {
      record("config.pub_sample");
    }
    config_ = config;
  }

  /// Publish a message to every topic that the logic publishes to by itself.
  void publish()
  {
    passthrough_.pub_plot_learn_cop->publish(contact_evaluate_types::PubPlotLearnCop());
  }

  ContactEvaluatePassthrough passthrough_;
  ContactEvaluateConfig config_;
  int updates_ = 0;
  Clock::time_point start_;
};

}  // namespace contact_analysis

#endif  // RECORDER__CONTACT_ANALYSIS__CONTACT_EVALUATE_IMPL_HPP_
