"""The scripts in workflows of GitHub and GitLab."""

import yaml


def script_of(file, job):
    """Return the script of a job: its last step in GitHub, all but its first line in GitLab."""
    workflow = yaml.safe_load(file.read_text())
    if "jobs" in workflow:
        return workflow["jobs"][job]["steps"][-1]["run"]
    return "\n".join(workflow[job]["script"][1:])
