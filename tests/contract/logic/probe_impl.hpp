#ifndef CONTRACT__PROBE_IMPL_HPP_
#define CONTRACT__PROBE_IMPL_HPP_

#include <cstddef>
#include <cstdint>
#include <string>

#include "contract/behaviour.hpp"
#include "contract/probe_interface.hpp"

namespace contract
{

/// The logic of probe: it does what the test tells it; see probe_impl.py.
class ProbeImpl
{
public:
  explicit ProbeImpl(const ProbePassthrough & passthrough);
  ~ProbeImpl() {behaviour_.pass("destructor");}
  bool configure(const ProbeConfig & config);
  bool activate();
  void update(ProbeData & data, const ProbeConfig & config);
  void receive_hear(const probe_types::HearMessage & message);
  void serve_serve(
    const probe_types::ServeService::Request & request,
    probe_types::ServeService::Response & response);
  void execute_work(Goal<probe_types::WorkAction> & goal);
  void execute_line(Goal<probe_types::LineAction> & goal);
  void execute_single(Goal<probe_types::SingleAction> & goal);
  void execute_choice(Goal<probe_types::ChoiceAction> & goal);
  void execute_crowd(Goal<probe_types::CrowdAction> & goal);
  bool accept_choice(const probe_types::ChoiceAction::Goal & request);
  void deactivate();
  void cleanup();

private:
  std::string call(double seconds);
  std::string calls(std::size_t count, double seconds);
  bool send(int order);
  std::string wait(const std::string & state);
  std::string goal(int order);
  std::string lookup(const std::string & target, const std::string & source, double seconds);
  std::string rounds(int count);

  template<typename Goal>
  void execute(const std::string & name, Goal & goal);

  ProbePassthrough passthrough_;
  Behaviour behaviour_;
  int cycles_ = 0;
  std::size_t listeners_ = 0;
  bool is_muted_ = false;
  std::uint64_t left_ = 0;
};

}  // namespace contract

#endif  // CONTRACT__PROBE_IMPL_HPP_
