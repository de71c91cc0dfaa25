#include "contract/probe_impl.hpp"

#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <future>
#include <new>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "contract/ros_places.hpp"

namespace
{

thread_local std::uint64_t allocations = 0;  // and what is freed

}  // namespace

void * operator new(std::size_t size)
{
  ++allocations;
  if (void * memory = std::malloc(size)) {
    return memory;
  }
  throw std::bad_alloc();
}

void operator delete(void * memory) noexcept
{
  ++allocations;
  std::free(memory);
}

void operator delete(void * memory, std::size_t) noexcept
{
  operator delete(memory);
}

namespace contract
{

namespace
{

void pause()
{
  std::this_thread::sleep_for(std::chrono::milliseconds(10));
}

std::chrono::duration<double> duration(double seconds)
{
  return std::chrono::duration<double>(seconds);
}

template<typename Publisher>
std::string publish(Publisher & publisher, const std::string & text)
{
  probe_types::PubSay message;
  message.data = text;
  publisher.publish(message);
  return "null";
}

}  // namespace

ProbeImpl::ProbeImpl(const ProbePassthrough & passthrough)
: passthrough_(passthrough),
  behaviour_("probe", {
      {"publish", [this](const auto & a) {return publish(*passthrough_.pub_say, a.at(0));}},
      {"shout", [this](const auto & a) {
          return publish(*passthrough_.pub_say, std::string(std::stoul(a.at(0)), 'x'));
        }},
      {"keep", [this](const auto & a) {return publish(*passthrough_.pub_kept, a.at(0));}},
      {"call", [this](const auto & a) {return call(std::stod(a.at(0)));}},
      {"calls", [this](const auto & a) {
          return calls(std::stoul(a.at(0)), std::stod(a.at(1)));
        }},
      {"send", [this](const auto & a) {return json(send(std::stoi(a.at(0))));}},
      {"cancel", [this](const auto &) {
          passthrough_.action_delegate->cancel();
          return std::string("null");
        }},
      {"state", [this](const auto &) {
          return json(to_string(passthrough_.action_delegate->state()));
        }},
      {"wait", [this](const auto & a) {return json(wait(a.at(0)));}},
      {"goal", [this](const auto & a) {return json(goal(std::stoi(a.at(0))));}},
      {"sleep", [this](const auto & a) {return json(passthrough_.sleep(std::stod(a.at(0))));}},
      {"lookup", [this](const auto & a) {return lookup(a.at(0), a.at(1), std::stod(a.at(2)));}},
      {"rounds", [this](const auto & a) {return rounds(std::stoi(a.at(0)));}},
      {"fail", [this](const auto & a) {
          passthrough_.fail(a.at(0));
          return std::string("null");
        }},
      {"later", [this](const auto & a) {
          const auto fail = passthrough_.fail;
          std::thread(
            [fail, pause = duration(std::stod(a.at(0))), reason = a.at(1)] {
              std::this_thread::sleep_for(pause);
              fail(reason);
            }).detach();
          return std::string("null");
        }},
      {"note", [this](const auto &) {
          passthrough_.log.info("noted each time");
          passthrough_.log.info_once("noted once");
          passthrough_.log.warning_throttle(1.0, "noted seldom");
          passthrough_.log.warning_once("noted once");
          return std::string("null");
        }},
      {"listeners", [this](const auto &) {
          const auto direct = std::to_string(passthrough_.pub_say->subscriber_count());
          return "[" + std::to_string(listeners_) + ", " + direct + "]";
        }},
      {"mute", [this](const auto &) {
          is_muted_ = true;
          return std::string("null");
        }},
    })
{
  behaviour_.pass("constructor");
}

std::string ProbeImpl::call(double seconds)
{
  const auto answer = passthrough_.client_ask->call(
    probe_types::ClientAsk::Request(), duration(seconds));
  return answer ? json(answer->message) : "null";
}

std::string ProbeImpl::calls(std::size_t count, double seconds)
{
  std::vector<std::future<std::string>> answers(count);
  for (auto & answer : answers) {
    answer = std::async(std::launch::async, [&] {return call(seconds);});
  }
  int answered = 0;
  for (auto & answer : answers) {
    answered += answer.get() != "null";
  }
  return std::to_string(answered);
}

bool ProbeImpl::send(int order)
{
  for (int tries = 0; tries < 1000 && !passthrough_.action_delegate->is_ready(); ++tries) {
    if (!passthrough_.sleep(0.01)) {
      return false;
    }
  }
  probe_types::ActionDelegate::Goal goal;
  goal.order = order;
  return passthrough_.action_delegate->send_goal(goal);
}

std::string ProbeImpl::wait(const std::string & state)
{
  while (to_string(passthrough_.action_delegate->state()) == state) {
    if (!passthrough_.sleep(0.01)) {
      return "stopped";
    }
  }
  return to_string(passthrough_.action_delegate->state());
}

std::string ProbeImpl::goal(int order)
{
  send(order);
  const std::string state = wait("pending");
  return state == "active" ? wait("active") : state;
}

std::string ProbeImpl::lookup(
  const std::string & target, const std::string & source, double seconds)
{
#if HAS_TF
  const auto found = passthrough_.listener_frames->lookup(target, source, duration(seconds));
  return found ? json(found->transform.translation.x) : json(passthrough_.listener_frames->reason());
#else
  throw std::logic_error("no lookup of " + target + source + std::to_string(seconds));
#endif
}

std::string ProbeImpl::rounds(int count)
{
  int calls = 0;
  int goals = 0;
  for (int number = 0; number < count; ++number) {
    calls += call(5.0) != "null";
    goals += goal(1) == "succeeded";
#if HAS_TF
    passthrough_.listener_frames->lookup("nowhere", "no_frame", duration(0.001));
#endif
  }
  return "[" + std::to_string(calls) + ", " + std::to_string(goals) + "]";
}

bool ProbeImpl::configure(const ProbeConfig & config)
{
  if (!config.accept) {
    behaviour_.trace("configure", "begin", json(config.accept));
    behaviour_.trace("configure", "end", "false");
    return false;
  }
  return behaviour_.run("configure", json(config.accept));
}

bool ProbeImpl::activate()
{
  return behaviour_.run("activate");
}

void ProbeImpl::update(ProbeData & data, const ProbeConfig & config)
{
  const auto by_the_loop = allocations - left_;  // since the last cycle left
  data.out_count.data = ++cycles_;
  const std::string number =
    data.in_number_updated ? std::to_string(data.in_number.data) : "null";
  const std::string map = data.in_map_updated ? json(data.in_map.data) : "null";
  listeners_ = data.out_count_subscribers;
  behaviour_.run(
    "update",
    "{\"number\": " + number + ", \"map\": " + map + ", \"gain\": " + json(config.gain) +
    ", \"allocations\": " + std::to_string(by_the_loop) + "}");
  data.out_count_active = !is_muted_;
  left_ = allocations;
}

void ProbeImpl::receive_hear(const probe_types::HearMessage & message)
{
  behaviour_.run("receive", json(message.data));
}

void ProbeImpl::serve_serve(
  const probe_types::ServeService::Request &, probe_types::ServeService::Response & response)
{
  behaviour_.run("serve");
  response.success = true;
  response.message = "served";
}

void ProbeImpl::execute_work(Goal<probe_types::WorkAction> & goal)
{
  execute("work", goal);
}

void ProbeImpl::execute_line(Goal<probe_types::LineAction> & goal)
{
  execute("line", goal);
}

void ProbeImpl::execute_single(Goal<probe_types::SingleAction> & goal)
{
  execute("single", goal);
}

void ProbeImpl::execute_choice(Goal<probe_types::ChoiceAction> & goal)
{
  execute("choice", goal);
}

void ProbeImpl::execute_crowd(Goal<probe_types::CrowdAction> & goal)
{
  execute("crowd", goal);
}

bool ProbeImpl::accept_choice(const probe_types::ChoiceAction::Goal & request)
{
  return behaviour_.run("accept", std::to_string(request.order));
}

template<typename Goal>
void ProbeImpl::execute(const std::string & name, Goal & goal)
{
  const int order = goal.request.order;
  goal.feedback.sequence.assign(1, order);
  goal.publish_feedback();
  behaviour_.run(name, std::to_string(order));
  while (order > 100 && !goal.cancel_requested()) {
    pause();
  }
  behaviour_.trace(name, "over", std::to_string(order));
  goal.result.sequence.assign(1, order);
  if (order > 100) {
    goal.canceled();
  } else if (order > 0) {
    goal.succeed();
  }
  if (order == 66) {
    throw std::runtime_error("told to raise");
  }
}

void ProbeImpl::deactivate()
{
  behaviour_.run("deactivate");
}

void ProbeImpl::cleanup()
{
  behaviour_.run("cleanup");
}

}  // namespace contract
