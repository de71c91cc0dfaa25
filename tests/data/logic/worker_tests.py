# ruff: noqa: PT009, PT027 (it runs where pytest may be missing)
"""Tests of the worker's logic as a developer writes them, with the harness of the package."""

import sys
import unittest

from all_kinds import worker_interface
from all_kinds.worker_impl import WorkerImpl
from all_kinds.worker_interface import (
    ActionDelegateResult,
    CallMessage,
    ClientPermitResponse,
    ComputeGoal,
    EnableRequest,
    EnableResponse,
    InSpeed,
    OutStatus,
    SayMessage,
    WorkerConfig,
    WorkerPassthrough,
)

sys.path.insert(0, sys.argv.pop(1))
from support import harness  # noqa: E402


class TestWorker(unittest.TestCase):
    def setUp(self):
        self.ros = harness.fake(WorkerPassthrough)
        self.impl = WorkerImpl(self.ros)
        self.impl.configure(WorkerConfig(prefix="hi", weights=(1.0,)))

    def said(self):
        return [message.data for message in self.ros.pub_echo.published]

    def test_cycles(self):
        speed = InSpeed()
        speed.linear.x = 2.0
        data = harness.run_cycle(self.impl, in_speed=speed)
        self.assertEqual(data.out_status.data, "worker 3 False")
        self.assertTrue(data.out_status_active)
        self.assertEqual(data.out_counter.data, 1)
        data = harness.run_cycle(self.impl, data, WorkerConfig(step=4))
        self.assertIs(data.in_speed, speed)
        self.assertFalse(data.out_status_active)
        self.assertEqual(data.out_counter.data, 5)
        self.assertEqual(
            self.ros.broadcaster_pose.sent[0],
            ("map", "worker", (1.0, 2.0, 3.0), (0.0, 0.0, 0.0, 1.0)),
        )

    def test_topics_of_a_list(self):
        call = CallMessage(data="come")
        self.impl.receive_call("hall/call", call)
        self.impl.receive_call("~/call", call)
        self.assertEqual(self.ros.pub_answer["hall/answer"].published, [call])
        self.assertEqual(self.ros.pub_answer["/answer"].published, [])

    def test_transforms(self):
        found = harness.protocols.Transform()
        found.transform.translation.x = 7.0
        harness.run_cycle(self.impl)
        self.assertIn("map", self.ros.listener_frames.reason)
        self.ros.listener_frames.transforms["map", "target"] = found
        harness.run_cycle(self.impl)
        self.assertEqual(self.said(), ["target 7"])
        self.assertEqual(self.ros.listener_frames.reason, "")

    def test_service_client(self):
        request = EnableRequest(data=False)
        answer = self.impl.serve_enable(request, EnableResponse())
        self.assertEqual((answer.success, answer.message), (False, "no answer"))
        self.assertFalse(self.ros.client_permit.is_ready())
        self.ros.client_permit.response = ClientPermitResponse(success=True, message="do")
        answer = self.impl.serve_enable(request, EnableResponse())
        self.assertEqual((answer.success, answer.message), (True, "do"))
        self.assertEqual(len(self.ros.client_permit.requests), 2)
        self.assertFalse(self.impl.enabled)

    def test_action_client(self):
        client = self.ros.action_delegate
        self.impl.receive_say(SayMessage(data="delegate"))
        self.assertEqual([goal.order for goal in client.goals], [5])
        client.state, client.result = "succeeded", ActionDelegateResult(sequence=[1, 2])
        harness.run_cycle(self.impl)
        self.assertEqual(self.said(), ["delegate", "delegate succeeded [1, 2]"])
        client.ready = False
        self.assertFalse(client.send_goal(client.goals[0]))
        self.assertEqual(client.state, "lost")

    def test_served_goal(self):
        goal = harness.FakeGoal(ComputeGoal, order=3)
        self.impl.execute_compute(goal)
        self.assertEqual((goal.outcome, list(goal.result.sequence)), ("succeeded", [0, 1, 1, 2]))
        self.assertEqual([len(each.sequence) for each in goal.published], [3, 4])
        goal = harness.FakeGoal(ComputeGoal, order=3)
        goal.cancel_requested = True
        self.impl.execute_compute(goal)
        self.assertEqual(goal.outcome, "canceled")

    def test_clock(self):
        self.ros.clock.time = 12.5
        self.assertTrue(self.ros.sleep(0.5))
        stamp = self.ros.stamp()
        self.assertEqual(self.ros.now(), 13.0)
        self.assertEqual(getattr(stamp, "sec", None) or stamp.secs, 13)
        self.ros.clock.stopped = True
        self.assertFalse(self.ros.sleep(1.0))
        self.assertEqual(self.ros.now(), 13.0)

    def test_misspelt(self):
        for messages in ({"in_sped": InSpeed()}, {"in_speed": OutStatus()}, {"in_sped": None}):
            with self.assertRaises(TypeError):
                harness.run_cycle(self.impl, **messages)
        with self.assertRaises(AttributeError):
            harness.FakeGoal(ComputeGoal, ordr=3)
        with self.assertRaises(AttributeError):
            self.ros.client_permit.respones = None
        with self.assertRaises(AttributeError):
            _ = self.ros.client_permission

        class Misspelt(WorkerImpl):
            def update(self, data: worker_interface.WorkerData, config: WorkerConfig) -> None:
                data.out_cuonter = 1

        with self.assertRaises(AttributeError):
            harness.run_cycle(Misspelt(self.ros))


unittest.main()
