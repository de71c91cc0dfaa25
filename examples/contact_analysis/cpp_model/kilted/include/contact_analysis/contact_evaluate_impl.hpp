// Copyright 2019 My Company
// SPDX-License-Identifier: GPL-3.0-only

#ifndef CONTACT_ANALYSIS__CONTACT_EVALUATE_IMPL_HPP_
#define CONTACT_ANALYSIS__CONTACT_EVALUATE_IMPL_HPP_

#include "contact_analysis/contact_evaluate_interface.hpp"

namespace contact_analysis
{

/// The logic of contact_evaluate.
///
/// Edit this file: contact_evaluate_interface.hpp declares what the logic can use.
class ContactEvaluateImpl
{
public:
  /// Store the passthrough.
  explicit ContactEvaluateImpl(
    const ContactEvaluatePassthrough & passthrough);

  /// Prepare the logic; return false to reject the configuration.
  bool configure(
    const ContactEvaluateConfig & config);

  /// Start operating; return false to refuse activation.
  bool activate();

  /// Compute the outputs of one cycle from the latest inputs.
  void update(
    ContactEvaluateData & data,
    const ContactEvaluateConfig & config);

  // Service load
  /// Fill in the response, in a thread of its own.
  void serve_load(
    const contact_evaluate_types::LoadService::Request & request,
    contact_evaluate_types::LoadService::Response & response);

  // Service store
  /// Fill in the response, in a thread of its own.
  void serve_store(
    const contact_evaluate_types::StoreService::Request & request,
    contact_evaluate_types::StoreService::Response & response);

  // Action learn
  /// Execute a goal and set its outcome, in a thread of its own; the stub only succeeds.
  void execute_learn(
    Goal<contact_evaluate_types::LearnAction> & goal);

  // Action evaluate
  /// Execute a goal and set its outcome, in a thread of its own; the stub only succeeds.
  void execute_evaluate(
    Goal<contact_evaluate_types::EvaluateAction> & goal);

  /// Stop everything that moves; publishers, service calls and goals still work here.
  void deactivate();

  /// Release everything created in configure.
  void cleanup();

private:
  ContactEvaluatePassthrough passthrough_;
};

}  // namespace contact_analysis

#endif  // CONTACT_ANALYSIS__CONTACT_EVALUATE_IMPL_HPP_
