function b(){const e=new Date,t=3600*e.getHours()+60*e.getMinutes()+e.getSeconds();return[e.getFullYear(),e.getMonth(),e.getDate(),t+e.getMilliseconds()/1e3]}const T=240,w=512,v=44100;
