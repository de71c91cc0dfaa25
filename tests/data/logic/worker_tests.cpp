// Tests of the worker's logic as a developer writes them, with the harness of the package.

#include <string>
#include <vector>

#include "gtest/gtest.h"

#include "./support/worker_harness.hpp"

using namespace all_kinds;  // NOLINT

class Worker : public ::testing::Test
{
protected:
  Worker() {harness.impl.configure(harness.config);}

  std::vector<std::string> said()
  {
    std::vector<std::string> texts;
    for (const auto & message : harness.pub_echo->published) {
      texts.push_back(message.data);
    }
    return texts;
  }

  WorkerHarness harness;
};

TEST_F(Worker, Cycles) {
  worker_types::InSpeed speed;
  speed.linear.x = 2.0;
  EXPECT_NE(harness.in_speed(speed).run_cycle().out_status.data.find("3"), std::string::npos);
  EXPECT_TRUE(harness.data.out_status_active);
  EXPECT_EQ(harness.data.out_counter.data, 1);
  harness.config.step = 4;
  EXPECT_EQ(harness.run_cycle().out_counter.data, 5);
  EXPECT_FALSE(harness.data.out_status_active);
  EXPECT_EQ(harness.data.in_speed.linear.x, 2.0);
  EXPECT_EQ(harness.broadcaster_pose->sent.at(0).child_frame_id, "worker");
}

TEST_F(Worker, TopicsOfAList) {
  worker_types::CallMessage call;
  call.data = "come";
  harness.impl.receive_call("hall/call", call);
  harness.impl.receive_call("~/call", call);
  EXPECT_EQ(harness.pub_answer.at("hall/answer")->published.at(0).data, "come");
  EXPECT_TRUE(harness.pub_answer.at("/answer")->published.empty());
}

TEST(Harness, HasTheTopicsOfItsParameters) {
  WorkerConfig config;
  config.answer_topics = {"kitchen"};
  WorkerHarness harness(config);
  EXPECT_EQ(harness.pub_answer.size(), 1u);
  EXPECT_EQ(harness.passthrough.pub_answer.at("kitchen"), harness.pub_answer.at("kitchen"));
}

TEST_F(Worker, Transforms) {
  harness.run_cycle();
  EXPECT_NE(harness.passthrough.listener_frames->reason().find("map"), std::string::npos);
  harness.listener_frames->transforms[{"map", "target"}].transform.translation.x = 7.0;
  harness.run_cycle();
  EXPECT_EQ(harness.passthrough.listener_frames->reason(), "");
  EXPECT_EQ(said().size(), 1u);
}

TEST_F(Worker, ServiceClient) {
  worker_types::EnableService::Request request;
  worker_types::EnableService::Response response;
  harness.impl.serve_enable(request, response);
  EXPECT_FALSE(response.success);
  worker_types::ClientPermit::Response permit;
  permit.success = true;
  permit.message = "do";
  harness.client_permit->response = permit;
  harness.impl.serve_enable(request, response);
  EXPECT_TRUE(response.success);
  EXPECT_EQ(response.message, "do");
  EXPECT_EQ(harness.client_permit->requests.size(), 2u);
}

TEST_F(Worker, ActionClient) {
  worker_types::SayMessage message;
  message.data = "delegate";
  harness.impl.receive_say(message);
  EXPECT_EQ(harness.action_delegate->goals.at(0).order, 5);
  harness.action_delegate->ready = false;
  EXPECT_FALSE(harness.passthrough.action_delegate->send_goal(harness.action_delegate->goals.at(0)));
  EXPECT_EQ(harness.passthrough.action_delegate->state(), ActionState::lost);
}

TEST_F(Worker, ServedGoal) {
  worker_types::ComputeAction::Goal request;
  request.order = 3;
  FakeGoal<worker_types::ComputeAction> goal(request);
  harness.impl.execute_compute(goal);
  EXPECT_EQ(goal.outcome(), Outcome::succeeded);
  EXPECT_EQ(goal.published.size(), 2u);
  FakeGoal<worker_types::ComputeAction> canceled(request);
  canceled.cancel = true;
  harness.impl.execute_compute(canceled);
  EXPECT_EQ(canceled.outcome(), Outcome::canceled);
}

TEST_F(Worker, Clock) {
  harness.time = Time(12500000000);
  EXPECT_TRUE(harness.passthrough.sleep(0.5));
  EXPECT_EQ(harness.passthrough.now().seconds(), 13.0);
  harness.stopped = true;
  EXPECT_FALSE(harness.passthrough.sleep(1.0));
  EXPECT_EQ(harness.passthrough.now().seconds(), 13.0);
  harness.passthrough.log.warning("so");
  EXPECT_EQ(harness.log.at(0), "so");
}
