import("../drawings/meeting.dxf");
