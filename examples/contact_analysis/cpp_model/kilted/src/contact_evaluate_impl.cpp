// Copyright 2019 My Company
// SPDX-License-Identifier: GPL-3.0-only

// The logic of contact_evaluate. Edit this file.

#include "contact_analysis/contact_evaluate_impl.hpp"

namespace contact_analysis
{

ContactEvaluateImpl::ContactEvaluateImpl(
  const ContactEvaluatePassthrough & passthrough)
: passthrough_(passthrough)
{
}

bool ContactEvaluateImpl::configure(
  [[maybe_unused]] const ContactEvaluateConfig & config)
{
  return true;
}

bool ContactEvaluateImpl::activate()
{
  return true;
}

void ContactEvaluateImpl::update(
  [[maybe_unused]] ContactEvaluateData & data,
  [[maybe_unused]] const ContactEvaluateConfig & config)
{
}

// Service load
void ContactEvaluateImpl::serve_load(
  [[maybe_unused]] const contact_evaluate_types::LoadService::Request & request,
  [[maybe_unused]] contact_evaluate_types::LoadService::Response & response)
{
}

// Service store
void ContactEvaluateImpl::serve_store(
  [[maybe_unused]] const contact_evaluate_types::StoreService::Request & request,
  [[maybe_unused]] contact_evaluate_types::StoreService::Response & response)
{
}

// Action learn
void ContactEvaluateImpl::execute_learn(
  Goal<contact_evaluate_types::LearnAction> & goal)
{
  goal.succeed();
}

// Action evaluate
void ContactEvaluateImpl::execute_evaluate(
  Goal<contact_evaluate_types::EvaluateAction> & goal)
{
  goal.succeed();
}

void ContactEvaluateImpl::deactivate()
{
}

void ContactEvaluateImpl::cleanup()
{
}

}  // namespace contact_analysis
