// Copyright 2019 My Company
// SPDX-License-Identifier: GPL-3.0-only

#ifndef CONTACT_ANALYSIS__CONTACT_EVALUATE_IMPL_HPP_
#define CONTACT_ANALYSIS__CONTACT_EVALUATE_IMPL_HPP_

#include "contact_analysis/contact_evaluate_interface.hpp"

namespace contact_analysis
{

/// The logic of contact_evaluate.
///
/// This file is yours: contact_evaluate_interface.hpp says what the logic can use.
/// ROS calls each callback in a thread of its own: guard with a mutex what they share.
class ContactEvaluateImpl
{
public:
  /// Keep what the logic may use at any time.
  explicit ContactEvaluateImpl(
    const ContactEvaluatePassthrough & passthrough);

  /// Prepare for work; return false to refuse the configuration.
  bool configure(
    const ContactEvaluateConfig & config);

  /// Turn the latest inputs into outputs, once in every cycle.
  void update(
    ContactEvaluateData & data,
    const ContactEvaluateConfig & config);

  // Service load
  /// Fill in the response to a request.
  void serve_load(
    const contact_evaluate_types::LoadService::Request & request,
    contact_evaluate_types::LoadService::Response & response);

  // Service store
  /// Fill in the response to a request.
  void serve_store(
    const contact_evaluate_types::StoreService::Request & request,
    contact_evaluate_types::StoreService::Response & response);

  // Action learn
  /// Work on a goal until it succeeds, is aborted, or its cancelling is requested.
  void execute_learn(
    Goal<contact_evaluate_types::LearnAction> & goal);

  // Action evaluate
  /// Work on a goal until it succeeds, is aborted, or its cancelling is requested.
  void execute_evaluate(
    Goal<contact_evaluate_types::EvaluateAction> & goal);

  // End of life
  /// Let go of what configure took.
  void cleanup();

private:
  ContactEvaluatePassthrough passthrough_;
};

}  // namespace contact_analysis

#endif  // CONTACT_ANALYSIS__CONTACT_EVALUATE_IMPL_HPP_
