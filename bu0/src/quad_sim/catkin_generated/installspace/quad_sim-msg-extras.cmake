set(quad_sim_MESSAGE_FILES "")
set(quad_sim_SERVICE_FILES "srv/CommandReport.srv;srv/RestoreState.srv;srv/SaveState.srv;srv/Step.srv")
