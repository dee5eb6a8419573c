import subprocess,json,sys,statistics as st
F=sys.argv[1]; n=int(sys.argv[2]); th=sys.argv[3]; names=sys.argv[4:] or ["nav_test","level","ot","turbine","dutility","complex","town","steelribs","fortitude"]
E="/work/shared/envs/"
import math
for e in names:
    p=e if '/' in e else (E+"town/town_model.gltf" if e=="town" else E+e+".obj")
    rs=[]
    for i in range(n):
        subprocess.run([F,"run",p,"--threads",th,"--quiet","-o","/tmp/critic/o/me_o.obj","--stats","/tmp/critic/o/me_s.json"],check=True,stdout=subprocess.DEVNULL)
        rs.append(json.load(open("/tmp/critic/o/me_s.json")))
    med=lambda f: st.median(f(r) for r in rs)
    steps=[x["name"] for x in rs[0]["steps"]]
    run=lambda r: r["start_ms"]+r["finish_ms"]+sum(x["wall_ms"] for x in r["steps"])
    parts=" ".join("%s %.1f"%(x[:4],med(lambda r,i=i:r["steps"][i]["wall_ms"])) for i,x in enumerate(steps) if i>1)
    print("%-10s run %.1f  load %.1f start %.1f %s nav %.1f exp %.1f | %s"%(e.split('/')[-1],med(run),med(lambda r:r["load_ms"]),med(lambda r:r["start_ms"]),parts,med(lambda r:r["finish_ms"]),med(lambda r:r["export_ms"]), subprocess.check_output(["sha256sum","/tmp/critic/o/me_o.obj"]).decode()[:8]),flush=True)
