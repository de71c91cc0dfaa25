# ruff: noqa: B015, B018, F821 (it stands at the end of a logic)
class Misspelt(WorkerImpl):
    """Every statement is wrong."""

    def configure(self, config: WorkerConfig) -> bool:
        self.passthrough.pub_ecko  # error: pub_ecko
        self.passthrough.log.wanring("x")  # error: wanring
        config.gian  # error: gian
        self.passthrough.client_permit.call(ResetRequest())  # error: incompatible type
        self.passthrough.action_delegate.state == "succeded"  # error: succeded
        return "yes"  # error: return value

    def receive_say(self, message: SayMessage) -> None:
        message.dta  # error: dta

    def serve_enable(self, request: EnableRequest, response: EnableResponse) -> EnableResponse:
        response.sucess = True  # error: sucess
        return request  # error: return value

    def execute_compute(self, goal: ComputeGoal) -> None:
        goal.result.sequenc = []  # error: sequenc
        goal.suceed()  # error: suceed
