// Copyright 2019 My Company
// SPDX-License-Identifier: GPL-3.0-only

#ifndef CONTACT_ANALYSIS__CONTACT_EVALUATE_IMPL_HPP_
#define CONTACT_ANALYSIS__CONTACT_EVALUATE_IMPL_HPP_

#include <array>
#include <cstddef>
#include <deque>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "contact_analysis/contact_evaluate_interface.hpp"

namespace contact_analysis
{

/// Centers of pressure, in the order in which they were measured.
using Cops = std::vector<contact_evaluate_types::InCop>;

/// Mean and standard deviation of the centers of pressure of a contact: x, y, z in m.
struct Contact
{
  /// Learn a contact from one center of pressure or more.
  static Contact learn(const Cops & cops);

  /// Return how far from the mean a center of pressure is, in standard deviations.
  double distance(const contact_evaluate_types::InCop & cop) const;

  std::array<double, 3> mean{};
  std::array<double, 3> deviation{};
};

/// The logic of contact_evaluate.
///
/// It learns where the center of pressure lies during a contact, and tells contacts apart by that.
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
  /// Execute a goal until it succeeds, is aborted, or a cancel is requested.
  void execute_learn(
    Goal<contact_evaluate_types::LearnAction> & goal);

  // Action evaluate
  /// Execute a goal until it succeeds, is aborted, or a cancel is requested.
  void execute_evaluate(
    Goal<contact_evaluate_types::EvaluateAction> & goal);

  /// Stop everything that moves; publishers, service calls and goals still work here.
  void deactivate();

  /// Release everything created in configure.
  void cleanup();

private:
  using Contacts = std::map<std::string, Contact>;
  using Buffer = std::deque<contact_evaluate_types::InCop>;

  /// Empty a buffer and return what it held.
  Cops take(Buffer & buffer);

  /// Return the name of the nearest contact that reaches a center of pressure, or none.
  std::string contact_of(const contact_evaluate_types::InCop & cop);

  ContactEvaluatePassthrough passthrough_;
  std::size_t samples_ = 0;
  std::mutex mutex_;  // protects what is below
  Contacts contacts_;
  Buffer to_learn_;
  Buffer to_evaluate_;
  bool plots_ = true;
};

}  // namespace contact_analysis

#endif  // CONTACT_ANALYSIS__CONTACT_EVALUATE_IMPL_HPP_
