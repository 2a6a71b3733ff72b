set(quad_control_MESSAGE_FILES "")
set(quad_control_SERVICE_FILES "srv/Advance.srv;srv/Begin.srv;srv/FlightRecord.srv;srv/SetFlightPlan.srv;srv/TimingReport.srv")
