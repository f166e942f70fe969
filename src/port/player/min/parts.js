const se={},ie={};
